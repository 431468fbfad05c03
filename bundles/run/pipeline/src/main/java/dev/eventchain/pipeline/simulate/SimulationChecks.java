package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.pipeline.generate.GeneratedPackage;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.ComponentSources;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.SimulationInputs;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.ArrayList;
import java.util.List;

/** Checks before anything is simulated. */
public final class SimulationChecks {

  private SimulationChecks() {}

  /**
   * Returns the findings in all that is simulated.
   *
   * @throws DiagnosticException FINDINGS with an error that nobody has accepted
   */
  public static List<Diagnostic> requireSound(RunContext run, List<Scenario> scenarios) {
    List<Diagnostic> found = inputs(run, scenarios);
    found.addAll(
        ComponentCopies.requireSame(run, run.chain().chain(), GeneratedPackage.required(run)));
    return found;
  }

  /** Returns the findings in what is simulated and its surroundings, of which no error is left. */
  static List<Diagnostic> inputs(RunContext run, List<Scenario> scenarios) {
    List<Diagnostic> found = new ArrayList<>(sources(run));
    found.addAll(connections(run));
    found.addAll(SimulationInputs.unknownNodes(run, scenarios));
    return found;
  }

  /**
   * Returns the findings in the source of components, unless the validation of this run has checked
   * it. Errors end the stage unless suppressed.
   */
  private static List<Diagnostic> sources(RunContext run) {
    if (run.options().runs(Stage.VALIDATE)) {
      return List.of();
    }
    List<Diagnostic> found = ComponentSources.of(run).check(Stage.SIMULATE);
    refuseErrors(run, found);
    return found;
  }

  /**
   * Returns the findings about unconnected parts of the bench. They end the stage unless
   * suppressed, since a simulation would prove nothing about the chain.
   */
  private static List<Diagnostic> connections(RunContext run) {
    List<Diagnostic> found = SimulationInputs.connections(run);
    refuseErrors(run, found);
    return found;
  }

  private static void refuseErrors(RunContext run, List<Diagnostic> found) {
    if (Diagnostic.anyError(run.options().suppressions().part(found).remaining())) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, found);
    }
  }
}

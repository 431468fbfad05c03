package dev.eventchain.simulation.variant;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.sandbox.ComponentRules;
import dev.eventchain.simulation.host.HostRules;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.verdict.VariantReaction;
import java.util.List;
import java.util.Optional;

/** A variant of a component in one scenario after the other, until one notices it. */
public final class VariantTrial {

  /** Failures of a node: by values of its component that it cannot send, or by its own code. */
  private static final List<Rule> OF_NODE =
      List.of(
          HostRules.NODE_FAILED,
          HostRules.NODE_TIMEOUT,
          HostRules.NODE_ENDPOINT_LATE,
          HostRules.MESSAGE_MALFORMED,
          HostRules.SIMULATION_LIMIT,
          HostRules.SIMULATION_STEP_TIMEOUT);

  private final List<PassedScenario> scenarios;

  /**
   * Creates a trial.
   *
   * @param scenarios all scenarios, in the order of the trial
   */
  public VariantTrial(List<PassedScenario> scenarios) {
    this.scenarios = scenarios;
  }

  /**
   * Drives the scenarios.
   *
   * @param runner runs them with the variant
   * @throws DiagnosticException if a run ends for another reason than what the component does
   */
  public VariantReaction run(ScenarioRunner runner) {
    boolean changed = false;
    PassedScenario.Judged nearest = PassedScenario.Judged.NONE;
    for (PassedScenario scenario : scenarios) {
      ScenarioRun run;
      try {
        run = runner.run(scenario.scenario());
      } catch (DiagnosticException e) {
        return raised(scenario, e);
      }
      PassedScenario.Judged judged = scenario.judge(run);
      if (judged.reaction().kind().isNoticed()) {
        return judged.reaction();
      }
      changed |= scenario.differs(run);
      if (judged.left() < nearest.left()) {
        nearest = judged;
      }
    }
    return changed
        ? nearest.reaction()
        : new VariantReaction(VariantReaction.Kind.UNCHANGED, "", "", Optional.empty());
  }

  private static VariantReaction raised(PassedScenario scenario, DiagnosticException end) {
    Diagnostic finding = end.diagnostics().get(0);
    boolean ofComponent =
        ComponentRules.find(finding.id()).isPresent() || OF_NODE.stream().anyMatch(finding::is);
    if (end.reason() != DiagnosticException.Reason.FINDINGS || !ofComponent) {
      throw end;
    }
    return scenario.reaction(VariantReaction.Kind.RAISED, finding.message(), Optional.empty());
  }
}

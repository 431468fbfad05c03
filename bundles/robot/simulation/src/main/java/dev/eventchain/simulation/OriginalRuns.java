package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.variant.VariantTrial;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * Runs of scenarios with the components as they are, which are repeated where a process ends: the
 * machine may have ended it.
 */
final class OriginalRuns {

  private final List<Scenario> scenarios;
  private final ScenarioRun[] done;
  private final Diagnostic[] ended;
  private final int[] ends;

  OriginalRuns(List<Scenario> scenarios) {
    this.scenarios = scenarios;
    this.done = new ScenarioRun[scenarios.size()];
    this.ended = new Diagnostic[scenarios.size()];
    this.ends = new int[scenarios.size()];
  }

  /** Drives a scenario; if the process ends, it has to be driven again in a new one. */
  HostPool.State drive(int number, ScenarioRunner runner) {
    try {
      done[number] = runner.run(scenarios.get(number));
      return HostPool.State.DONE;
    } catch (DiagnosticException e) {
      if (!VariantTrial.isEnd(e)) {
        throw e;
      }
      ends[number]++;
      if (ends[number] <= VariantSimulation.REPETITIONS) {
        return HostPool.State.UNDONE;
      }
      Diagnostic end = e.diagnostics().get(0);
      String message = "in the scenario %s, %d of %d times: %s";
      ended[number] =
          Diagnostic.of(
              end.kind(),
              message.formatted(
                  scenarios.get(number).name(), ends[number], ends[number], end.message()),
              scenarios.get(number).location());
      return HostPool.State.DONE_AT_THE_END;
    }
  }

  /** Returns the runs of the scenarios that came to their ends. */
  List<ScenarioRun> done() {
    return Arrays.stream(done).filter(Objects::nonNull).toList();
  }

  /** Returns the findings about the others, each with the name of its scenario. */
  List<Diagnostic> ended() {
    return Arrays.stream(ended).filter(Objects::nonNull).toList();
  }
}

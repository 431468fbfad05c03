package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.measure.MeasureRules;
import dev.eventchain.simulation.run.ScenarioRun;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/** Findings on results with nodes that run elsewhere. */
public final class AttachedFindings {

  private AttachedFindings() {}

  /**
   * Returns findings on a scenario in which the vehicle received nothing, so that it says nothing
   * about the software.
   */
  public static List<Diagnostic> silentIn(ScenarioRun run, SimulatedChain chain) {
    List<String> taken = chain.taken();
    if (taken.stream().anyMatch(topic -> !run.log().publicationsOf(topic).isEmpty())) {
      return List.of();
    }
    String topics = taken.isEmpty() ? "any topic" : String.join(", ", taken);
    return List.of(
        silent(
            "Scenario %s: the vehicle received nothing on %s."
                .formatted(run.scenario().name(), topics),
            taken.isEmpty() ? "" : chain.writer(taken.get(0))));
  }

  /**
   * Returns findings on topics of the vehicle that nothing wrote in any scenario, although other
   * messages came.
   */
  public static List<Diagnostic> neverHeard(List<ScenarioRun> runs, SimulatedChain chain) {
    List<String> taken = chain.taken();
    boolean anything = runs.stream().anyMatch(run -> silentIn(run, chain).isEmpty());
    return taken.stream()
        .filter(topic -> anything)
        .filter(topic -> runs.stream().allMatch(run -> run.log().publicationsOf(topic).isEmpty()))
        .map(topic -> silent(topic + " never arrived in any scenario.", chain.writer(topic)))
        .toList();
  }

  private static Diagnostic silent(String message, String element) {
    return Diagnostic.of(
            MeasureRules.NODE_SILENT, message, SourceLocation.NONE.withElement(element))
        .withHint("Do the nodes get their inputs, and do they follow /clock?");
  }

  /**
   * Returns the findings on the limits of a result with nodes that run elsewhere.
   *
   * @param driver the driver of the nodes, for users
   */
  public static List<Diagnostic> about(
      List<ScenarioRun> runs, SimulatedChain chain, String driver) {
    List<Diagnostic> found = new ArrayList<>();
    found.add(unseen(runs, chain, driver));
    if (runs.size() > 1) {
      found.add(
          Diagnostic.of(
                  JudgeRules.SIMULATION_ATTACHED_STATE,
                  String.format(
                      Locale.ROOT,
                      "%d scenarios were driven with the same nodes, which were not restarted:"
                          + " from the second one on they remember what happened before.",
                      runs.size()),
                  SourceLocation.NONE)
              .withHint("Restart the nodes for each scenario, and run it alone: --scenario NAME."));
    }
    return found;
  }

  private static Diagnostic unseen(List<ScenarioRun> runs, SimulatedChain chain, String driver) {
    Set<String> silent = new TreeSet<>(chain.topicsWritten());
    runs.forEach(run -> silent.removeAll(run.log().publications().keySet()));
    String unheard =
        silent.isEmpty() ? "" : " Nothing was received on " + String.join(", ", silent) + ".";
    return Diagnostic.of(
            JudgeRules.SIMULATION_ATTACHED_UNSEEN,
            ("The nodes were started elsewhere (%s): their executions, periods, execution times,"
                    + " latencies and ages of inputs were not measured.%s")
                .formatted(driver, unheard),
            SourceLocation.NONE)
        .withHint("Simulate with a driver that starts the nodes to measure them.");
  }
}

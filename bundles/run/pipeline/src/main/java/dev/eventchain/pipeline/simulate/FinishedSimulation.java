package dev.eventchain.pipeline.simulate;

import dev.eventchain.constraints.OclResult;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.results.BoundedLatency;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.stage.ProjectChecks;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.xmi.XmiStore;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** A simulation that has ended, with what it says of a project. */
final class FinishedSimulation {

  /** The folder of the curves of each scenario. */
  private static final String CURVES = "curves";

  /** Results of all scenarios, which must not be replaced by results of some. */
  private static final List<String> RESULTS =
      List.of(
          SimulateStage.MEASUREMENTS,
          SimulateStage.MEASUREMENTS_TABLE,
          SimulateStage.LATENCY_BOUNDS,
          ProjectLayout.VERDICT,
          SimulateStage.MEASURED_MODEL);

  private final RunContext run;
  private final EventChain chain;
  private final List<Scenario> scenarios;
  private final SimulationResult result;

  FinishedSimulation(RunContext run, List<Scenario> scenarios, SimulationResult result) {
    this.run = run;
    this.chain = run.chain().chain();
    this.scenarios = scenarios;
    this.result = result;
  }

  /** Writes what was measured, and the chain with it. */
  void writeMeasurements(EventChain measured) {
    run.writeResult(SimulateStage.MEASUREMENTS, result.toJson());
    run.writeResult(SimulateStage.MEASUREMENTS_TABLE, result.toCsv(chain));
    run.output().removeAll(CURVES);
    result.curves().forEach((scenario, table) -> run.writeResult(curvesOf(scenario), table));
    run.writeResult(SimulateStage.MEASURED_MODEL, XmiStore.toBytes(measured));
  }

  /**
   * Returns latencies with their bounds, writes them, and adds what is wrong with them and with the
   * execution times behind them.
   */
  List<BoundedLatency> latencies(List<Diagnostic> found) {
    List<BoundedLatency> latencies = LatencyBounds.of(run, result).report(run, scenarios, found);
    if (!run.options().isPartial()) {
      run.writeResult(SimulateStage.LATENCY_BOUNDS, ResultJson.indented(latencies));
      found.addAll(MeasuredTimes.propose(run, result));
    }
    return latencies;
  }

  private static String curvesOf(String scenario) {
    return CURVES + "/" + scenario + ".csv";
  }

  /** Returns the names of the results. */
  List<String> results() {
    if (run.options().isPartial()) {
      return List.of();
    }
    Stream<String> curves = result.verdicts().stream().map(verdict -> curvesOf(verdict.scenario()));
    return Stream.concat(RESULTS.stream(), curves).toList();
  }

  String measuredFile() {
    return SourceLocation.of(run.file(SimulateStage.MEASURED_MODEL)).file();
  }

  /** Returns the outcome of each requirement. */
  List<RequirementOutcome> outcomes(RuleEvidence evidence) {
    List<Scenario> judged = RequirementCoverage.judged(scenarios, result);
    Set<String> unproven = new TreeSet<>(RequirementCoverage.unproven(run, chain, judged).keySet());
    unproven.addAll(StaleEvidence.ids(StaleEvidence.of(run)));
    return RequirementOutcomes.of(
        run.writtenRequirements(),
        result.verdicts(),
        unproven,
        evidence,
        RequirementStrength.of(run, result));
  }

  /** Adds what was not tested. */
  void addUntested(List<RequirementOutcome> outcomes, List<Diagnostic> found) {
    List<Scenario> judged = RequirementCoverage.judged(scenarios, result);
    found.addAll(RequirementCoverage.untested(run, chain, judged));
    found.addAll(StaleEvidence.of(run));
    found.addAll(unmeasured());
    found.addAll(RequirementCoverage.unlisted(run, outcomes, found));
  }

  /** Returns findings about bounds on times that were never measured, and so were not tested. */
  private List<Diagnostic> unmeasured() {
    List<Diagnostic> found = new ArrayList<>();
    for (int i = 0; i < chain.getLatencyConstraints().size(); i++) {
      LatencyConstraint constraint = chain.getLatencyConstraints().get(i);
      int index = i;
      if (result.verdicts().stream().allMatch(each -> each.latencies().get(index).isEmpty())) {
        SourceLocation place = run.chain().locate(constraint);
        found.add(
            result.host().attached() ? unseen(constraint, place) : unmeasured(constraint, place));
      }
    }
    return found;
  }

  private static Diagnostic unseen(LatencyConstraint constraint, SourceLocation place) {
    return Diagnostic.of(
            SimulateRules.SIMULATION_LATENCY_UNMEASURED,
            "The latency constraint '%s' was not measured: the nodes were started elsewhere, so it is not known which output is based on which input."
                .formatted(constraint.getName()),
            place)
        .withHint("Simulate with a driver that starts the nodes, or measure it where they run.");
  }

  private static Diagnostic unmeasured(LatencyConstraint constraint, SourceLocation place) {
    return Diagnostic.of(
            SimulateRules.SIMULATION_LATENCY_UNMEASURED,
            "The latency constraint '%s' was not measured in any scenario: nothing that '%s' did was based on an input of '%s'."
                .formatted(
                    constraint.getName(), name(constraint.getLast()), name(constraint.getFirst())),
            place)
        .withHint("Bound the time between two simulated components that are connected by data.");
  }

  private static String name(SoftwareNode node) {
    return node == null ? "?" : node.getName();
  }

  /** Returns the simulation's part of the report. */
  Simulated report(
      List<BoundedLatency> latencies,
      OclResult validation,
      List<RequirementOutcome> outcomes,
      RuleEvidence evidence) {
    return SimulationReport.of(
        result,
        latencies,
        ProcessorReport.of(run.chain().chain()),
        evidence.untestedConstraints(),
        run.options().isPartial() ? List.of() : outcomes,
        RequirementStrength.limited(run, result),
        ProjectChecks.report(measuredFile(), validation));
  }

  /** Returns the verdict from all findings of the run, so that it is not better than the run. */
  byte[] verdict(List<RequirementOutcome> outcomes, List<Diagnostic> found) {
    return VerdictJson.of(
        chain,
        result,
        outcomes,
        RequirementStrength.limited(run, result),
        run.options().suppressions().part(found));
  }

  /** Returns what the stage says of it. */
  String details() {
    long passed = result.verdicts().stream().filter(ScenarioVerdict::passed).count();
    return String.format(
        Locale.ROOT,
        "%d of %d scenarios passed,%s%s %s",
        passed,
        result.verdicts().size(),
        RequirementStrength.details(run, result),
        result.faults().isEmpty() ? "" : " " + result.faults().size() + " runs with faults,",
        result.host().attached() ? result.host().driver() : how(result.host()));
  }

  private static String how(SimulationResult.Host host) {
    return String.format(
        Locale.ROOT, "%.0f times real time, %s", host.realTimeFactor(), host.confinement());
  }
}

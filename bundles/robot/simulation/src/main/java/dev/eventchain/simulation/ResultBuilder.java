package dev.eventchain.simulation;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.coverage.SignalCoverage;
import dev.eventchain.simulation.fault.Fault;
import dev.eventchain.simulation.host.HostRules;
import dev.eventchain.simulation.host.RunLog.Activation;
import dev.eventchain.simulation.judge.AttachedFindings;
import dev.eventchain.simulation.judge.FaultJudge;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.judge.WireFindings;
import dev.eventchain.simulation.measure.InputAges;
import dev.eventchain.simulation.measure.MessageFlows;
import dev.eventchain.simulation.measure.Silence;
import dev.eventchain.simulation.measure.ValueLatencies;
import dev.eventchain.simulation.measure.ValueRanges;
import dev.eventchain.simulation.run.FaultRun;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.verdict.FaultVerdict;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.world.Contact;
import dev.eventchain.simulation.world.World;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import java.util.zip.CRC32;

/** Judges the runs and computes the figures of the result. */
final class ResultBuilder {

  private static final double MILLISECOND = 1e6;

  private final SimulationRequest request;
  private final SimulatedChain chain;
  private final List<ScenarioRun> runs;
  private final List<FaultRun> faultRuns;
  private final List<SignalCoverage> signals;

  ResultBuilder(
      SimulationRequest request,
      SimulatedChain chain,
      List<ScenarioRun> runs,
      List<FaultRun> faultRuns,
      List<SignalCoverage> signals) {
    this.request = request;
    this.chain = chain;
    this.runs = runs;
    this.faultRuns = faultRuns;
    this.signals = signals;
  }

  SimulationResult build(String confinement, int processes, double wallSeconds) {
    List<Diagnostic> silent = silent();
    boolean worked = silent.stream().allMatch(request.settings().accepted());
    ScenarioJudge judge = new ScenarioJudge(chain, runs, request.settings().complete());
    ValueLatencies values = ValueLatencies.in(runs, chain);
    List<ScenarioVerdict> verdicts =
        runs.stream().map(run -> values.added(judge.verdict(run, worked(run, silent)))).toList();
    Measurements measurements = measurements(verdicts);
    SimulationResult.Host host = host(confinement, processes, wallSeconds);
    List<Diagnostic> found =
        Stream.of(
                silent,
                attached(),
                ignored(),
                tooOld(),
                ValueRanges.in(runs, chain),
                values.findings(),
                impacts(),
                runs.stream().flatMap(run -> ScenarioJudge.openEnd(run).stream()).toList(),
                fromBehind(),
                wire(),
                warnings())
            .flatMap(List::stream)
            .toList();
    return new SimulationResult(
        verdicts, measurements, found, faults(judge, worked), Optional.empty(), signals, host);
  }

  private SimulationResult.Host host(String confinement, int processes, double wallSeconds) {
    return new SimulationResult.Host(
        request.driverWords(),
        chain.isAttached(),
        confinement,
        runs.get(0).ready().path("python").asText(),
        processes,
        runs.stream().mapToDouble(run -> World.seconds(run.trace().end().time())).sum(),
        wallSeconds,
        runs.stream().mapToDouble(run -> World.seconds(run.hostNanos())).sum());
  }

  private List<FaultVerdict> faults(ScenarioJudge scenarios, boolean worked) {
    FaultJudge judge = new FaultJudge(chain, request.userFiles(), scenarios, worked);
    return faultRuns.stream().map(run -> judge.verdict(run, without(run.fault()))).toList();
  }

  /** Returns the run of a fault's scenario without the fault. */
  private ScenarioRun without(Fault fault) {
    return runs.stream()
        .filter(run -> run.scenario().name().equals(fault.scenario().name()))
        .findFirst()
        .orElseThrow(() -> new IllegalStateException("a fault in another scenario"));
  }

  /** Returns findings on components that did not work, as far as this is visible. */
  private List<Diagnostic> silent() {
    return chain.isAttached()
        ? AttachedFindings.neverHeard(runs, chain)
        : Silence.in(runs.stream().map(ScenarioRun::log).toList(), chain);
  }

  private List<Diagnostic> silentIn(ScenarioRun run) {
    return chain.isAttached() ? AttachedFindings.silentIn(run, chain) : List.of();
  }

  private boolean worked(ScenarioRun run, List<Diagnostic> silent) {
    return Stream.of(silent, silentIn(run))
        .flatMap(List::stream)
        .allMatch(request.settings().accepted());
  }

  /** Measures the nodes; nothing is measured of nodes that run elsewhere. */
  private Measurements measurements(List<ScenarioVerdict> verdicts) {
    if (chain.isAttached()) {
      return new Measurements(
          runId(verdicts, List.of()), "", "", List.of(), MessageFlows.of(runs, chain));
    }
    List<Measurements.Node> nodes = chain.nodes().stream().map(this::measure).toList();
    return new Measurements(
        runId(verdicts, nodes),
        chain.reader(chain.entry()),
        chain.writer(chain.exit()),
        nodes,
        MessageFlows.of(runs, chain));
  }

  /** Returns findings on the limits of a result with nodes that run elsewhere. */
  private List<Diagnostic> attached() {
    return chain.isAttached()
        ? Stream.concat(
                runs.stream().flatMap(run -> silentIn(run).stream()),
                AttachedFindings.about(runs, chain, request.driverWords()).stream())
            .toList()
        : List.of();
  }

  private Measurements.Node measure(SoftwareNode node) {
    DoubleStream.Builder periods = DoubleStream.builder();
    DoubleStream.Builder executionTimes = DoubleStream.builder();
    DoubleStream.Builder hostTimes = DoubleStream.builder();
    int activations = 0;
    for (ScenarioRun run : runs) {
      Activation previous = null;
      for (Activation activation : run.log().nodes().getOrDefault(node.getName(), List.of())) {
        activations++;
        executionTimes.add((activation.end() - activation.start()) / MILLISECOND);
        hostTimes.add(activation.host() / MILLISECOND);
        if (previous != null) {
          periods.add((activation.start() - previous.start()) / MILLISECOND);
        }
        previous = activation;
      }
    }
    double[] found = periods.build().toArray();
    double nominal = SimulatedChain.period(node);
    double[] jitter =
        nominal > 0
            ? DoubleStream.of(found).map(period -> Math.abs(period - nominal)).toArray()
            : new double[0];
    return new Measurements.Node(
        node.getName(),
        activations,
        Measurements.Statistics.of(found),
        Measurements.Statistics.of(jitter),
        Measurements.Statistics.of(executionTimes.build().toArray()),
        Measurements.Statistics.of(hostTimes.build().toArray()));
  }

  /**
   * Returns findings on commands that the simulated vehicle ignores, so that they were not tested.
   */
  private List<Diagnostic> ignored() {
    return runs.stream()
        .filter(run -> !run.trace().ignored().isEmpty())
        .limit(1)
        .map(
            run ->
                Diagnostic.of(
                        SimulationRules.SIMULATION_COMMAND_IGNORED,
                        "Scenario %s: the software commanded %s, which the simulated vehicle does not support."
                            .formatted(run.scenario().name(), run.trace().ignored()),
                        SourceLocation.NONE.withElement(onlyCommander()))
                    .withHint(
                        "Test what needs it with a vehicle that supports it, or do not command"
                            + " it."))
        .toList();
  }

  /** Returns the writer of the commands, if only one topic commands the vehicle. */
  private String onlyCommander() {
    return chain.commands().size() == 1 ? chain.writer(chain.exit()) : "";
  }

  /** Returns findings on impacts that no criterion is about. */
  private List<Diagnostic> impacts() {
    return runs.stream()
        .filter(run -> run.trace().impactSpeed().isPresent() && !run.scenario().judgesImpact())
        .map(ResultBuilder::impact)
        .toList();
  }

  private static Diagnostic impact(ScenarioRun run) {
    return Diagnostic.of(
            SimulationRules.SIMULATION_IMPACT_UNJUDGED,
            String.format(
                Locale.ROOT,
                "Scenario %s ended after %.2f s of %.2f s by an impact at %.1f km/h that no criterion"
                    + " is about: %s.",
                run.scenario().name(),
                World.seconds(run.trace().end().time()),
                run.scenario().duration(),
                run.trace().impactSpeed().getAsDouble() * 3.6,
                run.trace().impact()),
            run.scenario().location())
        .withHint(
            "Write no_impact: true if there must be none, or maximal_impact_speed_kmh if there may"
                + " be one.");
  }

  /**
   * Returns findings on rear impacts, which do not count as impacts of the ego; reported for any
   * criteria.
   */
  private List<Diagnostic> fromBehind() {
    return runs.stream()
        .flatMap(run -> run.trace().fromBehind().stream().map(each -> fromBehind(run, each)))
        .toList();
  }

  private static Diagnostic fromBehind(ScenarioRun run, Contact contact) {
    return Diagnostic.of(
            SimulationRules.SIMULATION_EGO_HIT_FROM_BEHIND,
            String.format(
                Locale.ROOT,
                "Scenario %s: %s at %.1f km/h after %.2f s.",
                run.scenario().name(),
                contact.words(),
                contact.speed() * 3.6,
                World.seconds(contact.time())),
            run.scenario().location())
        .withHint(
            "Find out whether the vehicle braked more than it had to, or else let the other vehicle"
                + " keep more distance: no criterion counts it as an impact.");
  }

  private List<Diagnostic> wire() {
    return runs.stream()
        .flatMap(run -> WireFindings.of(run.scenario(), run.lost(), run.notices()).stream())
        .toList();
  }

  private List<Diagnostic> tooOld() {
    return InputAges.in(runs, chain);
  }

  /** Returns findings on requested connections that were not made; the same in every scenario. */
  private List<Diagnostic> warnings() {
    Map<String, Diagnostic> warnings = new LinkedHashMap<>();
    for (ScenarioRun run : runs) {
      for (JsonNode warning : run.ready().path("warnings")) {
        String id = warning.path("id").asText();
        Rule rule = HostRules.find(id).orElseGet(() -> Rule.warning(id));
        String message = Printable.line(warning.path("message").asText());
        SourceLocation topic = SourceLocation.NONE.withElement(warning.path("topic").asText());
        warnings.putIfAbsent(id + message, Diagnostic.of(rule, message, topic));
      }
    }
    return Stream.concat(chain.leftOut().stream(), warnings.values().stream()).toList();
  }

  /** Returns a digest of everything measured in simulated time. */
  private static String runId(List<ScenarioVerdict> verdicts, List<Measurements.Node> nodes) {
    CRC32 digest = new CRC32();
    for (ScenarioVerdict verdict : verdicts) {
      String text = verdict.scenario() + verdict.passed() + verdict.latency() + verdict.series();
      text += verdict.flow();
      digest.update(text.getBytes(StandardCharsets.UTF_8));
    }
    for (Measurements.Node node : nodes) {
      String text = node.name() + node.activations() + node.period() + node.executionTime();
      digest.update(text.getBytes(StandardCharsets.UTF_8));
    }
    return String.format(Locale.ROOT, "simulation-%08x", digest.getValue());
  }
}

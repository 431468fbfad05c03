package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.chain.NodeConfiguration;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.coverage.CoverageRecord;
import dev.eventchain.simulation.fault.Fault;
import dev.eventchain.simulation.host.HostProgram;
import dev.eventchain.simulation.host.LockstepProcess;
import dev.eventchain.simulation.host.NodeHosts;
import dev.eventchain.simulation.run.FaultRun;
import dev.eventchain.simulation.run.Kept;
import dev.eventchain.simulation.run.MessageSamples;
import dev.eventchain.simulation.run.OutputFaultRun;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.strength.FaultTrial;
import dev.eventchain.simulation.strength.StrengthTrials;
import dev.eventchain.simulation.strength.TrialRound;
import dev.eventchain.simulation.verdict.Strength;
import dev.eventchain.simulation.wire.AttachedHosts;
import dev.eventchain.simulation.wire.ChainTopics;
import dev.eventchain.simulation.wire.DdsHosts;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * Simulates the generated nodes of a chain in a closed loop with a vehicle on a road. In lock-step
 * and on DDS in simulated time, world and nodes wait for each other, so the result depends only on
 * the nodes and the scenarios. In real time, nothing waits.
 */
public final class Simulation {

  /** The number of scenarios whose calls of components are replayed. */
  private static final int SCENARIOS_WITH_ANSWERS = 3;

  /** Scenarios with many criteria first, in which most happens; of these, the shortest. */
  private static final Comparator<Scenario> MOST_CRITERIA =
      Comparator.comparing((Scenario each) -> each.criteria().size(), Comparator.reverseOrder())
          .thenComparing(Scenario::duration)
          .thenComparing(Scenario::name);

  private final SimulationRequest request;
  private final SimulatedChain chain;
  private final Consumer<String> progress;
  private final PythonEnvironment python;
  private final Confinement confinement = Confinement.detect();
  private final Optional<Repetition> repetition;
  private final SortedMap<Integer, ScenarioRun> runs = new TreeMap<>();
  private final SortedMap<Integer, FaultRun> faultRuns = new TreeMap<>();
  private final SortedMap<Integer, CoverageRecord> coverage = new TreeMap<>();

  private Simulation(
      SimulationRequest request, PythonEnvironment python, Consumer<String> progress) {
    this.request = request;
    this.chain = request.simulatedChain();
    this.repetition = Repetition.of(request, chain);
    this.python = python;
    this.progress = progress;
  }

  /**
   * Simulates all scenarios and judges them.
   *
   * @param python the Python that runs the nodes
   * @param progress receives the name of each simulated scenario, and of each fault with its
   *     scenario, one at a time, from threads of the simulation; the order may differ from that of
   *     the request
   * @throws DiagnosticException (INPUT) if the messages of the vehicle are not defined ({@code
   *     message.unknown}, {@code message.field.missing}), or the manifest is not that of the chain
   *     ({@code simulation.manifest}), or there are faults that the driver cannot inject ({@code
   *     fault.driver}); (FINDINGS) if the nodes cannot be driven through a scenario: one raises,
   *     hangs, ends its process, or returns a value that contradicts its signature ({@code
   *     component.*}, {@code node.*}), or the process that runs the nodes hangs ({@code
   *     simulation.step.timeout}), ends ({@code simulation.process.ended}), writes or publishes
   *     without end ({@code simulation.limit}) or breaks the protocol ({@code
   *     simulation.protocol}); on DDS also if a node is stopped, lost or vanishes ({@code
   *     simulation.node.lost}), does not discover its peers ({@code simulation.wire.unmatched}), or
   *     creates end points while it runs ({@code node.endpoint.late}); (UNAVAILABLE) if the process
   *     cannot be started, or no DDS domain is free ({@code dds.domain.none})
   * @throws InterruptedException if the calling thread was interrupted; the processes are ended
   */
  public static SimulationResult run(
      SimulationRequest request, PythonEnvironment python, Consumer<String> progress)
      throws InterruptedException {
    return new Simulation(request, python, progress).run();
  }

  private SimulationResult run() throws InterruptedException {
    long started = System.nanoTime();
    refuseFaultsInRealTime();
    int processes = processes();
    NodeConfiguration nodes = new NodeConfiguration(chain, request.nodePackage());
    new HostPool(runsInAll(), this::start, (number, hosts) -> work(number, hosts, nodes))
        .run(processes);
    if (runs.size() + faultRuns.size() != runsInAll()) {
      throw new IllegalStateException("a scenario was not simulated");
    }
    double wallSeconds = (System.nanoTime() - started) / 1e9;
    List<ScenarioRun> driven = List.copyOf(runs.values());
    SimulationResult result =
        new ResultBuilder(
                request,
                chain,
                driven,
                List.copyOf(faultRuns.values()),
                CoverageRecord.of(chain, coverage.values(), request.scenarios()))
            .build(describeConfinement(), processes, wallSeconds);
    Optional<Diagnostic> differs = repeat(nodes);
    if (differs.isPresent()) {
      return result.with(differs.get());
    }
    return request.settings().strength().isPresent() && result.passed()
        ? result.withStrength(strength(nodes, driven))
        : result;
  }

  /** Repeats a scenario; returns a finding if the second run differs. */
  private Optional<Diagnostic> repeat(NodeConfiguration nodes) throws InterruptedException {
    if (repetition.isEmpty()) {
      return Optional.empty();
    }
    Repetition again = repetition.get();
    try {
      new HostPool(1, this::startAgain, (number, hosts) -> repeat(again, hosts, nodes)).run(1);
      return again.finding();
    } catch (DiagnosticException e) {
      if (e.reason() != DiagnosticException.Reason.FINDINGS) {
        throw e;
      }
      return Optional.of(again.ended(e.diagnostics().get(0)));
    }
  }

  private HostPool.State repeat(Repetition again, NodeHosts hosts, NodeConfiguration nodes) {
    new ScenarioRunner(chain, nodes, Optional.empty(), hosts.session(), Map.of())
        .run(
            again.scenario(),
            new Kept(false, Optional.of(again.second()), Optional.empty(), Optional.empty()));
    return HostPool.State.DONE;
  }

  private NodeHosts startAgain(int turn) {
    HostProgram program = new HostProgram(request.nodePackage(), python, confinement);
    int nodes = request.chain().getSoftware().size();
    return new LockstepProcess(program.withHashSeed(Repetition.HASH_SEED), nodes, turn);
  }

  /**
   * Measures the strength of the requirements by runs with standard faults of outputs, which are
   * judged like runs without faults.
   */
  private Strength strength(NodeConfiguration nodes, List<ScenarioRun> driven)
      throws InterruptedException {
    StrengthTrials trials =
        new StrengthTrials(chain, driven, request.settings().strength().orElseThrow());
    Optional<TrialRound<FaultTrial>> round = trials.next();
    while (round.isPresent()) {
      run(round.get(), nodes);
      round = trials.next();
    }
    return trials.strength();
  }

  private void run(TrialRound<FaultTrial> round, NodeConfiguration nodes)
      throws InterruptedException {
    HostPool.Job job = (number, hosts) -> work(round, number, hosts, nodes);
    new HostPool(round.size(), this::start, job).run(request.settings().processes());
  }

  private HostPool.State work(
      TrialRound<FaultTrial> round, int number, NodeHosts hosts, NodeConfiguration nodes) {
    Optional<FaultTrial> trial = round.begin(number);
    if (trial.isEmpty()) {
      return HostPool.State.DONE;
    }
    HostPool.State state = work(trial.get(), hosts, nodes);
    if (state == HostPool.State.DONE) {
      round.end(number);
    }
    return state;
  }

  /** Tries a fault in all its scenarios, unless it ends the processes before. */
  private HostPool.State work(FaultTrial trial, NodeHosts hosts, NodeConfiguration nodes) {
    ScenarioRunner runner =
        new ScenarioRunner(chain, nodes, Optional.empty(), hosts.session(), Map.of());
    Optional<OutputFaultRun> last = trial.next(runner);
    while (last.isPresent()) {
      if (last.get().ended().isPresent()) {
        return HostPool.State.UNDONE;
      }
      last = trial.next(runner);
    }
    tried(trial);
    return HostPool.State.DONE;
  }

  private synchronized void tried(FaultTrial trial) {
    progress.accept(trial.words());
  }

  /**
   * Returns the number of processes; in real time one, since parallel scenarios would slow each
   * other.
   */
  private int processes() {
    return isInRealTime() ? 1 : Math.min(request.settings().processes(), runsInAll());
  }

  private boolean isInRealTime() {
    return request.settings().driver() != SimulationDriver.LOCKSTEP
        && request.settings().driver() != SimulationDriver.DDS;
  }

  private String describeConfinement() {
    return request.isAttached() ? AttachedHosts.CONFINEMENT : confinement.describe();
  }

  private int runsInAll() {
    return request.scenarios().size() + request.settings().faults().faults().size();
  }

  private void refuseFaultsInRealTime() {
    if (isInRealTime()) {
      List<Diagnostic> refused =
          request.settings().faults().faults().stream()
              .map(Simulation::inRealTime)
              .distinct()
              .toList();
      if (!refused.isEmpty()) {
        throw new DiagnosticException(DiagnosticException.Reason.INPUT, refused);
      }
    }
  }

  private static Diagnostic inRealTime(Fault fault) {
    return Diagnostic.of(
            SimulationRules.FAULT_DRIVER,
            "The fault '" + fault.name() + "' cannot be injected in real time.",
            fault.location())
        .withHint("Leave out --real-time and --attach: in simulated time, all faults can.");
  }

  /** Simulates a run, which a fault may end. */
  private HostPool.State work(int number, NodeHosts hosts, NodeConfiguration nodes) {
    ScenarioRunner runner =
        new ScenarioRunner(
            chain, nodes, request.settings().recordings(), hosts.session(), recorded());
    int scenarios = request.scenarios().size();
    if (number < scenarios) {
      Scenario scenario = request.scenarios().get(number);
      Kept kept = kept(scenario);
      done(number, runner.run(scenario, kept), kept);
      return HostPool.State.DONE;
    }
    FaultRun run = runner.run(request.settings().faults().faults().get(number - scenarios));
    done(number, run);
    return run.ended().isEmpty() ? HostPool.State.DONE : HostPool.State.DONE_AT_THE_END;
  }

  private Kept kept(Scenario scenario) {
    return new Kept(
        answering().contains(scenario),
        repetition.filter(it -> it.scenario() == scenario).map(Repetition::first),
        request.settings().samples() ? Optional.of(new MessageSamples(chain)) : Optional.empty(),
        request.settings().coverage() && !isInRealTime()
            ? Optional.of(new CoverageRecord(chain))
            : Optional.empty());
  }

  /** Returns the scenarios in which the value latencies of the components are measured. */
  private List<Scenario> answering() {
    return request.settings().driver() == SimulationDriver.LOCKSTEP
        ? request.scenarios().stream().sorted(MOST_CRITERIA).limit(SCENARIOS_WITH_ANSWERS).toList()
        : List.of();
  }

  private Map<String, List<String>> recorded() {
    return request.settings().strength().isPresent() ? StrengthTrials.recorded(chain) : Map.of();
  }

  private NodeHosts start(int turn) {
    HostProgram program = new HostProgram(request.nodePackage(), python, confinement);
    return switch (request.settings().driver()) {
      case LOCKSTEP -> new LockstepProcess(program, request.chain().getSoftware().size(), turn);
      case DDS -> onDds(program, false, turn);
      case DDS_IN_REAL_TIME -> onDds(program, true, turn);
      case DDS_ATTACHED -> attached();
    };
  }

  private NodeHosts onDds(HostProgram program, boolean inRealTime, int turn) {
    List<String> names = chain.nodes().stream().map(SoftwareNode::getName).toList();
    return new DdsHosts(program, names, chain.catalog(), inRealTime, turn);
  }

  private NodeHosts attached() {
    Set<String> nodes =
        chain.nodes().stream()
            .map(node -> RosNames.nodeName(node.getName()))
            .collect(Collectors.toUnmodifiableSet());
    ChainTopics topics =
        new ChainTopics(chain.topicsWritten(), Set.copyOf(chain.taken()), nodes, chain.catalog());
    return new AttachedHosts(
        request.settings().attachment().orElseThrow(),
        topics,
        request.settings().limits().wallTime(),
        python);
  }

  private synchronized void done(int scenario, ScenarioRun run, Kept kept) {
    runs.put(scenario, run);
    kept.coverage().ifPresent(it -> coverage.put(scenario, it));
    progress.accept(run.scenario().name());
  }

  private synchronized void done(int number, FaultRun run) {
    faultRuns.put(number, run);
    progress.accept(run.fault().scenario().name() + " with " + run.fault().name());
  }
}

package dev.eventchain.simulation.run;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.simulation.chain.NodeConfiguration;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.fault.Fault;
import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.fault.WorldFault;
import dev.eventchain.simulation.host.NodeSession;
import dev.eventchain.simulation.host.NodeSession.Inbound;
import dev.eventchain.simulation.host.NodeSession.Outbound;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.recording.Recording;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * Drives one scenario in a loop: the world publishes sensor data, the nodes react, the vehicle
 * moves.
 */
public final class ScenarioRunner {

  /** Time until the end after the ego has stopped, in ns. */
  private static final long AFTER_STOP = 1_000_000_000L;

  /** Minimum time until the end after a fault, in ns. */
  private static final long AFTER_FAULT = 2_000_000_000L;

  private final SimulatedChain chain;
  private final NodeConfiguration nodes;
  private final Optional<Path> recordings;
  private final NodeSession session;
  private final Map<String, List<String>> outputs;

  /**
   * Creates a runner.
   *
   * @param nodes their configuration
   * @param recordings the folder of the recordings; empty for none
   * @param outputs the paths of the fields to record in runs without a fault, by topic
   */
  public ScenarioRunner(
      SimulatedChain chain,
      NodeConfiguration nodes,
      Optional<Path> recordings,
      NodeSession session,
      Map<String, List<String>> outputs) {
    this.chain = chain;
    this.nodes = nodes;
    this.recordings = recordings;
    this.session = session;
    this.outputs = outputs;
  }

  /** Drives a scenario, and observes nothing but its messages. */
  public ScenarioRun run(Scenario scenario) {
    return run(scenario, Kept.NOTHING);
  }

  /**
   * Drives a scenario without a fault.
   *
   * @param kept what is kept of it
   */
  public ScenarioRun run(Scenario scenario, Kept kept) {
    OutputRecord published = new OutputRecord(outputs);
    BenchDriver driver =
        driver(scenario, new WorldFault(Optional.empty()), published, kept, recordings.isPresent());
    JsonNode ready =
        session.configure(configuration(scenario, driver).put("answers", kept.answers()));
    driver.startAt(session.epoch());
    Optional<Recording> recording = recording(scenario.name(), scenario, driver);
    try {
      World world = world(scenario);
      long hostNanos =
          drive(world, driver, scenario.horizon(), duration(scenario), recording, EarlyEnd.never());
      ScenarioRun run =
          finish(scenario, world, ready, published, hostNanos)
              .with(kept.samples().map(MessageSamples::fields).orElse(List.of()));
      recording.ifPresent(it -> it.finish("at its end"));
      return run;
    } catch (DiagnosticException e) {
      // The recording before a failure is the most useful one.
      recording.ifPresent(it -> it.finishAfter(e));
      throw e;
    } finally {
      recording.ifPresent(Recording::close);
    }
  }

  /**
   * Drives the scenario of a fault with the fault. The run continues without a node that fails; any
   * other cause of an early end is part of the result.
   */
  public FaultRun run(Fault fault) {
    List<Expectation> criteria = new ArrayList<>(fault.scenario().criteria());
    criteria.addAll(fault.expected());
    Scenario scenario = fault.scenario().with(criteria);
    WorldFault atWorld = new WorldFault(Optional.of(fault));
    OutputRecord none = new OutputRecord(Map.of());
    BenchDriver driver = driver(scenario, atWorld, none, Kept.NOTHING, recordings.isPresent());
    ObjectNode configuration = configuration(scenario, driver);
    configuration.set("fault", fault.toJson());
    World world = world(scenario);
    long decided = fault.end() < RunLog.NEVER ? fault.end() : fault.start();
    long horizon = Math.max(scenario.horizon(), decided + AFTER_FAULT);
    JsonNode ready = session.configure(configuration);
    Optional<Recording> recording = recording(fault.recording(), scenario, driver);
    try {
      long hostNanos =
          drive(world, driver, horizon, duration(scenario), recording, EarlyEnd.never());
      FaultRun run =
          new FaultRun(
              fault, finish(scenario, world, ready, none, hostNanos), atWorld, Optional.empty());
      recording.ifPresent(it -> it.finish("at its end"));
      return run;
    } catch (DiagnosticException e) {
      recording.ifPresent(it -> it.finishAfter(e));
      return new FaultRun(
          fault, endedBy(e, scenario, world, ready), atWorld, Optional.of(e.diagnostics().get(0)));
    } finally {
      recording.ifPresent(Recording::close);
    }
  }

  /** Begins a recording, if there are to be any. */
  private Optional<Recording> recording(String name, Scenario scenario, BenchDriver driver) {
    return recordings.map(
        to -> new Recording(to, name, scenario, driver.recorded(), chain.catalog()));
  }

  /**
   * Drives a scenario with a fault of an output, until the criteria of the scenario are decided. As
   * with {@link #run(Fault)}, the run continues without a node that fails, and nothing is recorded.
   *
   * @param decided returns whether the trace of a beginning shows all that matters; the trace of a
   *     run that ends with it is cut
   */
  public OutputFaultRun run(Scenario scenario, OutputFault fault, Predicate<Trace> decided) {
    OutputRecord none = new OutputRecord(Map.of());
    BenchDriver driver =
        driver(scenario, new WorldFault(Optional.empty()), none, Kept.NOTHING, false);
    ObjectNode configuration = configuration(scenario, driver);
    configuration.set("fault", fault.toJson(scenario.seed()));
    World world = world(scenario);
    JsonNode ready = session.configure(configuration);
    try {
      long hostNanos =
          drive(
              world,
              driver,
              scenario.horizon(),
              duration(scenario),
              Optional.empty(),
              EarlyEnd.once(decided));
      ScenarioRun run = finish(scenario, world, ready, none, hostNanos);
      return new OutputFaultRun(fault, run, Optional.empty());
    } catch (DiagnosticException e) {
      return new OutputFaultRun(
          fault, endedBy(e, scenario, world, ready), Optional.of(e.diagnostics().get(0)));
    }
  }

  /** Returns the run until it was ended by a fault; throws what no fault can cause. */
  private static ScenarioRun endedBy(
      DiagnosticException end, Scenario scenario, World world, JsonNode ready) {
    if (end.reason() != DiagnosticException.Reason.FINDINGS) {
      throw end;
    }
    return new ScenarioRun(
        scenario,
        world.trace(),
        new RunLog(Map.of(), Map.of()),
        ready,
        Map.of(),
        List.of(),
        new OutputRecord(Map.of()),
        List.of(),
        0,
        0);
  }

  private BenchDriver driver(
      Scenario scenario, WorldFault fault, OutputRecord published, Kept kept, boolean recorded) {
    return new BenchDriver(chain, scenario, fault, published, kept, recorded);
  }

  private ObjectNode configuration(Scenario scenario, BenchDriver driver) {
    return nodes.of(scenario.seed(), scenario.phases(), driver.published(), driver.received());
  }

  private static World world(Scenario scenario) {
    Situation situation = scenario.situation();
    return new World(situation, new Trace(scenario.inputs(), situation.road()));
  }

  private static long duration(Scenario scenario) {
    return World.nanoseconds(scenario.duration());
  }

  /**
   * Advances time until the run is over; returns the wall time that this took, in ns. A run is over
   * at its end, at an impact, where the scenario ends, or at an early end. It is also over when the
   * ego and all others have come to rest and no criterion needs more.
   */
  private long drive(
      World world,
      BenchDriver driver,
      long least,
      long end,
      Optional<Recording> recording,
      EarlyEnd early) {
    long stoppedAt = world.egoSpeed() > 0 ? Long.MAX_VALUE : end;
    long started = System.nanoTime();
    long horizon = Math.min(end, least);
    while (world.now() < end
        && !world.isOver()
        && !early.isNow(world, driver)
        && (world.now() < horizon || world.now() - AFTER_STOP < stoppedAt || !othersRest(world))) {
      List<Inbound> sensed = driver.sense(world);
      recording.ifPresent(it -> it.sensed(world, sensed));
      long until = Math.min(end, driver.nextDue());
      for (Outbound outbound : session.step(until, sensed)) {
        recording.ifPresent(it -> it.took(outbound));
        driver.take(outbound, world);
      }
      world.advanceTo(until);
      stoppedAt = stoppedAt(world, stoppedAt);
    }
    driver.expire(world);
    recording.ifPresent(it -> it.scene(world));
    return System.nanoTime() - started;
  }

  /**
   * Returns when the ego came to rest, given that until now; never while it drives. As long as it
   * turns on the spot, that is now.
   */
  static long stoppedAt(World world, long before) {
    if (world.egoSpeed() > 0.0) {
      return Long.MAX_VALUE;
    }
    boolean turns = !world.egoRests() && before < world.now();
    return before == Long.MAX_VALUE || turns ? world.now() : before;
  }

  private static boolean othersRest(World world) {
    double now = World.seconds(world.now());
    return !world.waits() && world.actors().stream().allMatch(each -> each.restsFrom(now));
  }

  private ScenarioRun finish(
      Scenario scenario, World world, JsonNode ready, OutputRecord published, long hostNanos) {
    RunLog log = session.finish();
    if (world.impacted() && !scenario.allowsImpact()) {
      world.trace().cutShort();
    }
    return new ScenarioRun(
        scenario,
        world.trace(),
        log,
        ready,
        session.lost(),
        session.notices(),
        published,
        List.of(),
        session.overrun(),
        hostNanos);
  }
}

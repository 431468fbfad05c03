package dev.eventchain.simulation;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.simulation.LockstepChannel.Inbound;
import dev.eventchain.simulation.LockstepSession.Outbound;
import java.util.List;
import java.util.Optional;

/** Drives one scenario: the vehicle senses, the nodes think, the vehicle moves. */
final class ScenarioRunner {

  /** How long it goes on after the ego has stopped, in ns. */
  private static final long AFTER_STOP = 1_000_000_000L;

  /**
   * What happened.
   *
   * @param ready what the process said of itself and the connections of the nodes
   * @param hostNanos time on this machine for the steps
   */
  record Run(Scenario scenario, Trace trace, RunLog log, JsonNode ready, long hostNanos) {}

  private final NodeSetup setup;
  private final LockstepSession session;

  ScenarioRunner(NodeSetup setup, LockstepSession session) {
    this.setup = setup;
    this.session = session;
  }

  Run run(Scenario scenario) {
    BenchDriver driver = new BenchDriver(setup, scenario);
    JsonNode ready = session.configure(setup.configuration(scenario, driver));
    Optional<Recording> recording =
        setup.recordings().map(to -> new Recording(to, scenario, driver, setup.catalog()));
    try {
      Run run = drive(scenario, driver, ready, recording);
      recording.ifPresent(it -> it.finish("at its end"));
      return run;
    } catch (DiagnosticException e) {
      // What led to it is worth more than any other recording.
      recording.ifPresent(it -> it.finishAfter(e));
      throw e;
    } finally {
      recording.ifPresent(Recording::close);
    }
  }

  private Run drive(
      Scenario scenario, BenchDriver driver, JsonNode ready, Optional<Recording> recording) {
    Situation situation = scenario.situation();
    World world = new World(situation, new Trace(scenario.inputs(), situation.road()));
    long end = World.nanoseconds(scenario.duration());
    long stoppedAt = scenario.situation().ego().speed() > 0 ? Long.MAX_VALUE : end;
    long started = System.nanoTime();
    long horizon = Math.min(end, scenario.horizon());
    while (world.now() < end
        && !world.impacted()
        && (world.now() < horizon || world.now() - AFTER_STOP < stoppedAt)) {
      List<Inbound> sensed = driver.sense(world);
      recording.ifPresent(it -> it.sensed(world, sensed));
      long until = Math.min(end, driver.nextDue());
      for (Outbound outbound : session.step(until, sensed)) {
        recording.ifPresent(it -> it.took(outbound));
        driver.take(outbound, world);
      }
      world.advanceTo(until);
      if (world.egoSpeed() > 0.0) {
        stoppedAt = Long.MAX_VALUE;
      } else if (stoppedAt == Long.MAX_VALUE) {
        stoppedAt = world.now();
      }
    }
    driver.finish(world);
    recording.ifPresent(it -> it.scene(world));
    long hostNanos = System.nanoTime() - started;
    return new Run(scenario, world.trace(), session.finish(), ready, hostNanos);
  }
}

package dev.eventchain.simulation.judge;

import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;

/**
 * Motion of a scenario's vehicle without what the software demands, up to the scenario's duration:
 * once with software that demands nothing, so that the driver keeps the pedals; and, if the
 * software took the pedals or the wheel from the driver, once with a driver who lets go of them at
 * that time as well.
 */
final class WithoutSoftware {

  /** Smallest noticeable difference of positions, in m. */
  private static final double ALONG = 0.5;

  /** Smallest noticeable difference of speeds, in m/s. */
  private static final double SPEED = 0.2;

  /** Smallest noticeable difference of offsets in the lane, in m. */
  private static final double ACROSS = 0.05;

  /** Smallest noticeable difference of headings, in rad. */
  private static final double HEADING = 0.01;

  private final List<Trace> traces;
  private final boolean differs;

  /**
   * Drives a scenario without its software.
   *
   * @param run the run with the software, which is not kept
   */
  WithoutSoftware(ScenarioRun run, SimulatedChain chain) {
    boolean steers = chain.drives(Actuator.STEERING, Actuator.STEERING_ANGLE, Actuator.YAW_RATE);
    Trace with = run.trace();
    traces = new ArrayList<>();
    traces.add(drive(run, steers, OptionalLong.empty(), OptionalLong.empty()));
    if (with.pedalsTaken().isPresent() || with.wheelTaken().isPresent()) {
      traces.add(drive(run, steers, with.pedalsTaken(), with.wheelTaken()));
    }
    differs = differ(with.states(), traces.get(0).states());
  }

  private static Trace drive(
      ScenarioRun run, boolean steers, OptionalLong pedals, OptionalLong wheel) {
    Scenario scenario = run.scenario();
    Situation situation = scenario.situation();
    World world = new World(situation, new Trace(scenario.inputs(), situation.road()));
    world.release(pedals, wheel);
    for (Trace.Command command : run.trace().commands()) {
      world.command(command.time(), VehicleCommand.idle(steers));
    }
    world.advanceTo(World.nanoseconds(scenario.duration()));
    if (world.impacted() && !scenario.allowsImpact()) {
      world.trace().cutShort();
    }
    return world.trace();
  }

  /** Returns the traces, without messages. */
  List<Trace> traces() {
    return traces;
  }

  /** Returns whether the software noticeably changed how the vehicle moves. */
  boolean differs() {
    return differs;
  }

  private static boolean differ(List<Trace.State> with, List<Trace.State> without) {
    if (without.size() < with.size()) {
      return true;
    }
    for (int i = 0; i < with.size(); i++) {
      if (differ(with.get(i), without.get(i))) {
        return true;
      }
    }
    return false;
  }

  private static boolean differ(Trace.State with, Trace.State without) {
    return Math.abs(with.position() - without.position()) > ALONG
        || Math.abs(with.speed() - without.speed()) > SPEED
        || Math.abs(with.pose().offset() - without.pose().offset()) > ACROSS
        || Math.abs(with.pose().heading() - without.pose().heading()) > HEADING;
  }
}

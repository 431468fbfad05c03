package dev.eventchain.simulation.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.Chassis;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.LidarSettings;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Tests when the ego has come to rest, after which a run may end before its time. */
class ScenarioRunnerTest {

  private static final long END = World.nanoseconds(20);

  private final EgoVehicle robot =
      new EgoVehicle(
          1.0,
          0.0,
          0.0,
          1.0,
          0.0,
          1.0,
          LidarSettings.USUAL,
          new Chassis(0.4, 0.6, 0.0, 0.0, 0.0, 0.0, 1.5));

  private void command(World world, double speed, double yawRate, double until) {
    world.command(
        world.now(),
        VehicleCommand.of(Map.of(Actuator.SPEED, speed, Actuator.YAW_RATE, yawRate), robot));
    world.advanceTo(World.nanoseconds(until));
  }

  /** It stands after 1.5 s, turns until 5 s, and rests from then on. */
  @Test
  void aRobotThatTurnsOnTheSpotDoesNotRest() {
    World world = new World(robot, List.of());
    assertEquals(Long.MAX_VALUE, ScenarioRunner.stoppedAt(world, Long.MAX_VALUE));
    command(world, 0.0, 0.0, 1.5);
    long stopped = ScenarioRunner.stoppedAt(world, Long.MAX_VALUE);
    assertEquals(World.nanoseconds(1.5), stopped);
    command(world, 0.0, 0.5, 5.0);
    assertEquals(World.nanoseconds(5), ScenarioRunner.stoppedAt(world, stopped));
    command(world, 0.0, 0.0, 6.0);
    assertTrue(world.egoRests());
    assertEquals(World.nanoseconds(5), ScenarioRunner.stoppedAt(world, World.nanoseconds(5)));
    assertEquals(END, ScenarioRunner.stoppedAt(world, END), "one that never drove");
  }
}

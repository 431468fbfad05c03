package dev.eventchain.simulation.stage;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Tests an ego that a file in OpenSCENARIO XML has turn, on a plane without roads. */
class PlayedTurnTest {

  private static final Path FOLDER = Path.of("src/test/resources/openscenario");

  private final Situation situation =
      Scenario.parse(
              SourceText.of(
                  FOLDER.resolve("scenario.yaml").toString(),
                  """
                  name: left-turn
                  title: A turn
                  openscenario: {file: left-turn.xosc}
                  accept: {no_impact: true}
                  """),
              Bench.carla())
          .situation();

  private final World world = world();

  private World world() {
    return new World(situation, new Trace(Map.of(), situation.road()));
  }

  private static void drive(World world, double seconds) {
    world.advanceTo(world.now() + World.nanoseconds(seconds));
  }

  /** Returns where a vehicle without software is, every 0.02 s. */
  private List<Road.Place> untouched() {
    World alone = world();
    List<Road.Place> places = new ArrayList<>();
    for (int i = 0; i < 300; i++) {
      places.add(alone.ego().front());
      drive(alone, 0.02);
    }
    return places;
  }

  private void assertOnTheWay(double seconds) {
    Road.Place front = world.ego().front();
    Road.Place nearest =
        untouched().stream()
            .min(Comparator.comparingDouble(place -> distance(place, front)))
            .orElseThrow();
    assertEquals(0, distance(nearest, front), 0.1, () -> "braked after " + seconds + " s");
    assertEquals(nearest.heading(), front.heading(), 0.05, () -> "braked after " + seconds + " s");
  }

  private static double distance(Road.Place one, Road.Place other) {
    return StrictMath.hypot(one.x() - other.x(), one.y() - other.y());
  }

  @Test
  void anEgoThatBrakesKeepsToItsTrajectory() {
    drive(world, 2.5);
    world.command(world.now(), VehicleCommand.brake(0.2));
    drive(world, 1.5);
    assertTrue(world.ego().front().heading() > 0.1, "it brakes in the turn");
    assertTrue(world.egoSpeed() < 3, "it brakes");
    assertOnTheWay(2.5);
    drive(world, 5);
    assertEquals(0, world.egoSpeed());
    assertOnTheWay(2.5);
  }

  /** A command of the brake has a field for the wheel, too, in many interfaces. */
  @Test
  void aSteeringOfZeroLeavesTheWheelToTheStoryboard() {
    world.command(world.now(), VehicleCommand.idle(true));
    drive(world, 5);
    Road.Place alone = untouched().get(250);
    assertTrue(alone.heading() > 1, "a turn");
    assertEquals(alone, world.ego().front());
  }

  @Test
  void anotherSteeringTakesTheWheel() {
    drive(world, 1);
    world.command(world.now(), VehicleCommand.of(Map.of(Actuator.STEERING, 0.2), situation.ego()));
    drive(world, 3);
    assertTrue(world.ego().front().heading() < -0.1, "to the right");
    world.command(world.now(), VehicleCommand.idle(true));
    drive(world, 0.5);
    double kept = world.ego().front().heading();
    drive(world, 1);
    assertEquals(kept, world.ego().front().heading(), 1e-9, "a steering of 0 is a command now");
  }
}

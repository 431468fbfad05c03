package dev.eventchain.simulation.judge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Shape;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests that the scene from above shows the positions of everything. */
class SceneFromAboveTest {

  private static ScenarioVerdict.Scene scene(Situation situation, double seconds) {
    World world = new World(situation, new Trace(java.util.Map.of(), situation.road()));
    world.advanceTo(World.nanoseconds(seconds));
    return SceneFromAbove.of(situation, world.trace(), world.trace().states());
  }

  @Test
  void everythingStandsWhereItWas() {
    Situation situation =
        Situation.straight(
            EgoVehicle.withSpeed(10),
            List.of(Actor.passengerCar(30, 5, 3.5), Actor.passengerCar(60, 0, -3.5)));
    ScenarioVerdict.Scene scene = scene(situation, 2);
    assertEquals(201, scene.ego().x().size());
    assertEquals(20 - Shape.USUAL.length() / 2, scene.ego().x().get(200), 1e-9);
    assertEquals(List.of(0.0), scene.ego().y());
    assertEquals(30 + 2.25 + 10, scene.others().get(0).x().get(200), 1e-9);
    assertEquals(List.of(3.5), scene.others().get(0).y());
    assertEquals(List.of(62.25), scene.others().get(1).x(), "what stands is said once");
  }

  @Test
  void inABendTheyStandOnTheArc() {
    Situation straight =
        Situation.straight(EgoVehicle.withSpeed(10), List.of(Actor.passengerCar(50, 0, 0)));
    Road road = Road.bend(1.0 / 100, 3.5);
    Situation situation = new Situation(straight.ego(), straight.driver(), road, straight.actors());
    ScenarioVerdict.Mover car = scene(situation, 1).others().get(0);
    double radius = Math.hypot(car.x().get(0), car.y().get(0) - 100);
    assertEquals(100, radius, 1e-9);
    assertEquals(0.5225, car.heading().get(0), 1e-9);
  }

  @Test
  void whoDroveIntoTheRearIsGone() {
    Situation situation =
        Situation.straight(EgoVehicle.withSpeed(10), List.of(Actor.passengerCar(-20, 20, 0)));
    List<Double> x = scene(situation, 4).others().get(0).x();
    assertTrue(Double.isFinite(x.get(0)));
    assertTrue(x.get(x.size() - 1).isNaN());
  }
}

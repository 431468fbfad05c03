package dev.eventchain.simulation.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests a road of constant curvature, and the driver who follows it. */
class BendTest {

  private static final long SECOND = 1_000_000_000L;

  private static World world(double radius, double speed, LateralProfile line, Actor... actors) {
    Road road = Road.bend(radius == 0 ? 0 : 1 / radius, Road.USUAL_LANE_WIDTH);
    HumanDriver driver =
        new HumanDriver(new SpeedProfile(speed, List.of()), line, !line.constant());
    Situation situation = new Situation(EgoVehicle.withSpeed(speed), driver, road, List.of(actors));
    return new World(situation, new Trace());
  }

  private static final LateralProfile MIDDLE = new LateralProfile(0, List.of());

  @ParameterizedTest
  @ValueSource(doubles = {40, -40, 250, -250, 2000})
  void stationIsThePlaceAgain(double radius) {
    Road road = Road.bend(1 / radius, 3.5);
    for (double along = -30; along < 900; along += 13.7) {
      for (double across = -7; across < 8; across += 3.1) {
        Road.Place place = road.place(along, across);
        Road.Station station = road.station(place.x(), place.y(), along + 5);
        assertEquals(along, station.along(), 1e-6);
        assertEquals(across, station.across(), 1e-6);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {100, -100, 300, -1000})
  void driverFollowsTheBend(double radius) {
    World world = world(radius, 15, MIDDLE);
    for (int i = 1; i <= 100; i++) {
      world.advanceTo(i * SECOND / 5);
      assertEquals(0, world.station().across(), 0.25);
    }
    assertEquals(300, world.station().along(), 1);
    assertEquals(15 / radius, world.moment().end().pose().yawRate(), 0.002);
  }

  @Test
  void softwareThatSteersTakesTheWheel() {
    World world = world(100, 15, MIDDLE);
    world.command(0, VehicleCommand.brake(0));
    world.advanceTo(2 * SECOND);
    assertEquals(0, world.station().across(), 0.25, "no steering is no command to steer");
    world.command(
        2 * SECOND, VehicleCommand.of(Map.of(Actuator.STEERING, 0.01), EgoVehicle.withSpeed(15)));
    world.advanceTo(5 * SECOND);
    assertTrue(world.station().across() < -1.5, "it leaves the lane to the outside");
  }

  @Test
  void vehicleAheadInTheBendIsApproachedAlongTheRoad() {
    World world = world(100, 15, MIDDLE, Actor.passengerCar(50, 5, 0));
    world.advanceTo(2 * SECOND);
    assertEquals(30, world.trace().end().gap(), 0.3);
    world.advanceTo(9 * SECOND);
    assertTrue(world.impacted());
    assertEquals(5, World.seconds(world.now()), 0.1);
  }

  @Test
  void driverDriftsAsHisScriptSays() {
    World world =
        world(0, 25, new LateralProfile(0, List.of(new LateralProfile.Change(1, 1.5, 0.5))));
    double most = 0;
    double before = 0;
    for (int i = 1; i <= 1000; i++) {
      world.advanceTo(i * SECOND / 100);
      most = Math.max(most, (world.station().across() - before) * 100);
      before = world.station().across();
    }
    assertEquals(0.5, most, 0.1);
    assertEquals(1.5, before, 0.05);
    assertFalse(world.impacted());
  }

  @Test
  void driverChangesTheSpeedAsHisScriptSays() {
    HumanDriver driver =
        new HumanDriver(
            new SpeedProfile(10, List.of(new SpeedProfile.Change(1, 20, 2))), MIDDLE, false);
    World world =
        new World(
            new Situation(EgoVehicle.withSpeed(10), driver, Road.straight(), List.of()),
            new Trace());
    world.advanceTo(3 * SECOND);
    assertEquals(14, world.egoSpeed(), 0.3);
    world.advanceTo(8 * SECOND);
    assertEquals(20, world.egoSpeed(), 0.05);
  }

  /** Compares the wall, ray by ray, with a march of small steps. */
  @ParameterizedTest
  @ValueSource(doubles = {60, -60, 400})
  void wallsBendWithTheRoad(double radius) {
    Road road = Road.bend(1 / radius, 3.5);
    Road.Place from = road.place(20, 1.5);
    for (double azimuth = -3; azimuth < 3; azimuth += 0.37) {
      double dx = Math.cos(azimuth);
      double dy = Math.sin(azimuth);
      double marched = 0;
      while (marched < 200
          && Math.abs(road.station(from.x() + marched * dx, from.y() + marched * dy, 20).across())
              < Road.WALL_DISTANCE) {
        marched += 0.005;
      }
      assertEquals(marched, Math.min(200, road.wall(from, dx, dy)), 0.01);
    }
  }
}

package dev.eventchain.simulation.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.ValueSource;

class WorldTest {

  private static final long SECOND = 1_000_000_000L;
  private static final long PERIOD = 50_000_000L;

  private static World empty(double speed) {
    return new World(EgoVehicle.withSpeed(speed), List.of());
  }

  @Test
  void driverHoldsTheSpeedUntilTheFirstBrakeCommand() {
    World world = empty(20);
    world.command(0, VehicleCommand.brake(0.0));
    world.advanceTo(3 * SECOND);
    assertEquals(20, world.egoSpeed());
    assertEquals(60, world.station().along(), 1e-9);
  }

  @Test
  void brakeActsAfterTheDelayAndBuildsUpLinearly() {
    World world = empty(20);
    world.command(0, VehicleCommand.brake(1.0));
    world.advanceTo(SECOND / 5);
    assertEquals(20, world.egoSpeed());
    world.advanceTo(SECOND / 5 + SECOND * 15 / 100);
    assertEquals(4.5, world.moment().end().deceleration(), 1e-9);
    assertEquals(20 - 0.5 * 4.5 * 0.15, world.egoSpeed(), 1e-9);
    world.advanceTo(SECOND / 2);
    assertEquals(9, world.moment().end().deceleration(), 1e-9);
    assertEquals(20 - 0.5 * 9 * 0.3, world.egoSpeed(), 1e-9);
  }

  /** Way = delay + ramp (v t - j t^3 / 6) + v^2 / (2 a), from the definition of the point mass. */
  @Test
  void stoppingDistanceIsThatOfThePointMass() {
    World world = empty(50 / 3.6);
    world.command(0, VehicleCommand.brake(1.0));
    world.advanceTo(5 * SECOND);
    double v = 50 / 3.6;
    double afterRamp = v - 0.5 * 9 * 0.3;
    double expected =
        v * 0.2 + v * 0.3 - 30 * 0.3 * 0.3 * 0.3 / 6 + afterRamp * afterRamp / (2 * 9);
    assertEquals(0, world.egoSpeed());
    assertEquals(0, world.moment().end().deceleration());
    assertEquals(expected, world.station().along(), 1e-6);
  }

  @ParameterizedTest
  @ValueSource(longs = {1_000_000L, 7_000_003L, 50_000_000L})
  void resultDoesNotDependOnTheStep(long step) {
    World coarse = braked(4 * SECOND);
    World fine = braked(step);
    assertEquals(coarse.station().along(), fine.station().along(), 1e-9);
    assertEquals(coarse.egoSpeed(), fine.egoSpeed(), 1e-9);
    assertTrue(fine.egoSpeed() > 0);
  }

  private static World braked(long step) {
    World world = empty(30);
    world.command(123_456_789L, VehicleCommand.brake(0.5));
    world.command(SECOND, VehicleCommand.brake(0.0));
    world.command(2 * SECOND, VehicleCommand.brake(0.7));
    while (world.now() < 4 * SECOND) {
      world.advanceTo(Math.min(4 * SECOND, world.now() + step));
    }
    return world;
  }

  @Test
  void releasedVehicleCoastsAndNeverDrivesBackwards() {
    World world = empty(5);
    world.command(0, VehicleCommand.brake(1.0));
    world.command(SECOND * 3 / 10, VehicleCommand.brake(0.0));
    world.advanceTo(SECOND);
    assertEquals(0.5, world.moment().end().deceleration(), 1e-9);
    double before = world.egoSpeed();
    world.advanceTo(2 * SECOND);
    assertEquals(before - 0.5, world.egoSpeed(), 1e-9);
    world.advanceTo(30 * SECOND);
    assertEquals(0, world.egoSpeed());
  }

  @Test
  void pedalIsLimitedAndNoNumberDoesNotBrake() {
    World over = empty(20);
    over.command(0, VehicleCommand.brake(7.0));
    over.advanceTo(SECOND);
    assertEquals(9, over.moment().end().deceleration(), 1e-9);
    World none = empty(20);
    none.command(0, VehicleCommand.brake(Double.NaN));
    none.command(0, VehicleCommand.brake(-1.0));
    none.advanceTo(SECOND);
    assertEquals(20, none.egoSpeed());
  }

  @Test
  void impactIsFoundAtItsInstantWithTheRelativeSpeed() {
    Actor slower = Actor.passengerCar(10, 5, 0);
    World world = new World(EgoVehicle.withSpeed(15), List.of(slower));
    world.advanceTo(3 * SECOND);
    assertTrue(world.impacted());
    assertTrue(Math.abs(world.now() - SECOND) <= 2);
    assertEquals(10, world.trace().impactSpeed().orElseThrow(), 1e-6);
    assertEquals(0, world.trace().minimalGap().orElseThrow(), 1e-6);
  }

  @Test
  void vehicleInTheNextLaneIsNeitherHitNorApproached() {
    Actor beside = Actor.passengerCar(10, 0, 3.5);
    World world = new World(EgoVehicle.withSpeed(15), List.of(beside));
    world.advanceTo(3 * SECOND);
    assertFalse(world.impacted());
    assertTrue(world.trace().minimalGap().isEmpty());
    assertEquals(Double.POSITIVE_INFINITY, world.trace().end().timeToCollision());
  }

  @Test
  void targetBrakesToStandstillAndStaysThere() {
    SpeedProfile target = new SpeedProfile(10, List.of(new SpeedProfile.Change(1, 0, 5)));
    assertEquals(10, target.way(1));
    assertEquals(7.5, target.speed(1.5));
    assertEquals(20, target.way(3), 1e-12);
    assertEquals(20, target.way(9), 1e-12);
    assertEquals(0, target.speed(9));
  }

  @Test
  void timeToCollisionIsTheGapOverTheClosingSpeed() {
    World world = new World(EgoVehicle.withSpeed(20), List.of(Actor.passengerCar(30, 10, 0)));
    assertEquals(3, world.trace().end().timeToCollision(), 1e-12);
    world.advanceTo(SECOND);
    assertEquals(2, world.trace().end().timeToCollision(), 1e-12);
  }

  /**
   * Applies an ideal controller with the paper's thresholds to the true TTC every 50 ms.
   * Independently calculated impact speeds lie between those of the best and the worst instant of
   * control.
   */
  @ParameterizedTest
  @CsvFileSource(resources = "/impact-speeds.csv", numLinesToSkip = 1)
  void impactSpeedsWithThePapersThresholds(
      double deceleration,
      double delay,
      double buildUp,
      double partial,
      double kmh,
      double impact) {
    EgoVehicle ego =
        new EgoVehicle(
            kmh / 3.6, delay, buildUp, deceleration, 0, 3, LidarSettings.USUAL, Chassis.USUAL);
    DoubleSummaryStatistics impacts = new DoubleSummaryStatistics();
    for (double early = 0.0005; early < 0.05; early += 0.007) {
      World world = new World(ego, List.of(Actor.passengerCar((4 + early) * ego.speed(), 0, 0)));
      drive(world, partial);
      impacts.accept(world.trace().impactSpeed().orElse(0) * 3.6);
    }
    assertTrue(
        impacts.getMin() - 0.5 <= impact && impact <= impacts.getMax() + 0.5, impacts::toString);
    assertTrue(impacts.getMax() - impacts.getMin() < 13, impacts::toString);
  }

  private static void drive(World world, double partial) {
    while (!world.impacted() && world.egoSpeed() > 0.01 && world.now() < 20 * SECOND) {
      double ttc = world.trace().end().timeToCollision();
      world.command(world.now(), VehicleCommand.brake(ttc < 1 ? 1 : ttc < 2 ? partial : 0));
      world.advanceTo(world.now() + PERIOD);
    }
  }

  @Test
  void throttleSpeedsUpInProportionAndEndsTheHoldOfTheDriver() {
    World world = empty(10);
    world.advanceTo(SECOND);
    assertEquals(10, world.egoSpeed(), 1e-9, "the driver holds the speed");
    world.command(SECOND, VehicleCommand.drive(1.0));
    world.advanceTo(3 * SECOND);
    // 0.2 s delay, then a ramp of 30 m/s3 to 3 m/s2: 0.1 s at half of it, 1.7 s in full.
    assertEquals(10 + 0.1 * 1.5 + 1.7 * 3, world.egoSpeed(), 1e-6);
    assertEquals(-3, world.moment().end().deceleration(), 1e-9);
    world.command(3 * SECOND, VehicleCommand.drive(0.0));
    world.advanceTo(4 * SECOND);
    assertEquals(0.5, world.moment().end().deceleration(), 1e-9, "it coasts");
  }

  @Test
  void halfThrottleIsBetweenCoastingAndFullAcceleration() {
    World world = empty(10);
    world.command(0, VehicleCommand.drive(0.5));
    world.advanceTo(2 * SECOND);
    assertEquals(-(0.5 * 3.5 - 0.5), world.moment().end().deceleration(), 1e-9);
  }

  @Test
  void standingVehicleDrivesOffAndStopsAgain() {
    World world = empty(0);
    world.command(0, VehicleCommand.drive(0.3));
    world.advanceTo(3 * SECOND);
    assertTrue(world.egoSpeed() > 1, () -> "speed " + world.egoSpeed());
    double before = world.station().along();
    assertTrue(before > 1);
    world.command(3 * SECOND, VehicleCommand.brake(1.0));
    world.advanceTo(6 * SECOND);
    assertEquals(0, world.egoSpeed());
    double stood = world.station().along();
    world.advanceTo(7 * SECOND);
    assertEquals(stood, world.station().along());
    world.command(7 * SECOND, VehicleCommand.drive(1.0));
    world.advanceTo(9 * SECOND);
    assertTrue(world.station().along() > stood + 1);
  }

  @Test
  void brakeWinsOverThrottle() {
    World world = empty(20);
    world.command(0, VehicleCommand.pedals(1.0, 1.0));
    world.advanceTo(SECOND);
    assertEquals(9, world.moment().end().deceleration(), 1e-9);
  }

  @Test
  void speedDoesNotDependOnTheStepsWithThrottleEither() {
    World fine = empty(5);
    World coarse = empty(5);
    for (World world : new World[] {fine, coarse}) {
      world.command(0, VehicleCommand.drive(0.8));
      world.command(SECOND, VehicleCommand.brake(0.4));
      world.command(2 * SECOND, VehicleCommand.drive(0.2));
    }
    for (long time = 0; time <= 4 * SECOND; time += 7_777_777L) {
      fine.advanceTo(time);
    }
    fine.advanceTo(4 * SECOND);
    coarse.advanceTo(4 * SECOND);
    assertEquals(coarse.station().along(), fine.station().along(), 1e-6);
    assertEquals(coarse.egoSpeed(), fine.egoSpeed(), 1e-6);
  }
}

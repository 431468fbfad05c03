package dev.eventchain.simulation.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.sensor.Lidar;
import dev.eventchain.simulation.sensor.RoadScene;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Chassis;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.LidarSettings;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Shape;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the vehicle besides its pedals: steering, hand brake, gears and drag. */
class SteeringTest {

  private static final long SECOND = 1_000_000_000L;
  private static final EgoVehicle USUAL = EgoVehicle.withSpeed(10);

  private static EgoVehicle with(double speed, Chassis chassis) {
    return new EgoVehicle(speed, 0.0, 0.3, 9.0, 0.5, 3.0, LidarSettings.USUAL, chassis);
  }

  private static Trace.State after(World world, double seconds) {
    world.advanceTo(World.nanoseconds(seconds));
    return world.moment().end();
  }

  private static VehicleCommand steer(double steering) {
    return VehicleCommand.of(Map.of(Actuator.STEERING, steering), USUAL);
  }

  @ParameterizedTest
  @CsvSource({"10,-0.1", "10,0.15", "25,-0.02", "3,1", "17.5,0.05"})
  void pathIsThatOfAnIndependentIntegration(double speed, double steering) {
    Chassis usual = Chassis.USUAL;
    Chassis chassis = new Chassis(2.7, usual.maximalSteeringAngle(), 3, 0, 0.4, 0.02);
    World world = new World(with(speed, chassis), List.of());
    world.command(0, steer(steering));
    Trace.State state = after(world, 1.5);

    // Euler steps of the kinematic bicycle, from the rear axle, which is 3.6 m behind the bumper.
    double heading = 0.02;
    double x = -3.6 * Math.cos(heading);
    double y = 0.4 - 3.6 * Math.sin(heading);
    double start = x + 3.6 * Math.cos(heading);
    int steps = 1_500_000;
    double rate = speed / 2.7 * Math.tan(-steering * usual.maximalSteeringAngle());
    for (int i = 0; i < steps; i++) {
      x += speed * Math.cos(heading) * 1e-6;
      y += speed * Math.sin(heading) * 1e-6;
      heading += rate * 1e-6;
    }
    assertEquals(heading, state.pose().heading(), 1e-4);
    assertEquals(rate, state.pose().yawRate(), 1e-9);
    assertEquals(y + 3.6 * Math.sin(heading), state.pose().offset(), 1e-3);
    assertEquals(x + 3.6 * Math.cos(heading) - start, state.position(), 1e-3);
  }

  @Test
  void driverHoldsTheSpeedWhileTheSoftwareOnlySteers() {
    World world = new World(USUAL, List.of());
    world.command(0, steer(0.01));
    assertEquals(10, after(world, 5).speed());
  }

  @Test
  void evadingAVehicleIsNoImpactAndSteeringIntoOneIs() {
    World evades = new World(with(10, Chassis.USUAL), List.of(Actor.passengerCar(30, 0, 0)));
    evades.command(0, steer(-0.1));
    evades.advanceTo(SECOND);
    evades.command(SECOND, steer(0.1));
    evades.advanceTo(2 * SECOND);
    evades.command(2 * SECOND, steer(0));
    evades.advanceTo(6 * SECOND);
    assertFalse(evades.impacted());
    assertTrue(evades.moment().end().pose().offset() > 2);

    World beside = new World(with(10, Chassis.USUAL), List.of(Actor.passengerCar(-2, 10, 3)));
    beside.command(0, steer(-0.1));
    beside.advanceTo(6 * SECOND);
    assertTrue(beside.impacted());

    // Its front is behind the ego's, but the bodies are side by side.
    World behind = new World(with(10, Chassis.USUAL), List.of(Actor.passengerCar(-5.5, 10, 3)));
    behind.command(0, steer(-0.1));
    behind.advanceTo(2 * SECOND);
    assertTrue(behind.impacted());
  }

  /** Its rear axle is on a circle about the centre of the bend from the start, 3.6 m behind. */
  @ParameterizedTest
  @CsvSource({"50, 0", "-50, 0", "50, 1", "-400, -0.5"})
  void beginsSteadilyInABend(double radius, double offset) {
    String text =
        """
        name: bend
        title: A bend
        duration_s: 3
        road: {curve_radius_m: %s}
        ego: {speed_kmh: 36, lateral_offset_m: %s, driver_steers: true}
        accept: {never_brakes: true}
        """
            .formatted(radius, offset);
    Scenario scenario = Scenario.parse(SourceText.of("bend.yaml", text), Bench.carla());
    World world = new World(scenario.situation(), new Trace(Map.of(), scenario.situation().road()));
    world.advanceTo(2 * SECOND);
    double front = Math.abs(radius - offset);
    double rate = Math.signum(radius) * 10 / Math.sqrt(front * front - 3.6 * 3.6);
    for (Trace.State state : world.trace().states()) {
      assertEquals(rate, state.pose().yawRate(), Math.abs(rate) * 4e-3);
      assertEquals(offset, state.pose().offset(), 2e-3);
    }
  }

  @Test
  void leavingTheRoadIsAnImpact() {
    World world = new World(with(10, Chassis.USUAL), List.of());
    world.command(0, steer(0.5));
    world.advanceTo(6 * SECOND);
    assertTrue(world.impacted());
    assertEquals(-(8 - Shape.USUAL.width() / 2), world.moment().end().pose().offset(), 0.1);
    Criterion noImpact =
        new Criterion(CriterionKind.NO_IMPACT, 0, Criterion.Tolerances.USUAL, SourceLocation.NONE);
    assertTrue(noImpact.judge(world.trace()).tested());
    assertFalse(noImpact.judge(world.trace()).passed());
  }

  @Test
  void handBrakeStopsTheVehicleAndHoldsIt() {
    World world = new World(with(9, Chassis.USUAL), List.of());
    world.command(0, VehicleCommand.of(Map.of(Actuator.HAND_BRAKE, 1.0), USUAL));
    assertEquals(3, after(world, 1).deceleration(), 1e-9);
    assertEquals(0, after(world, 4).speed());
    world.command(
        4 * SECOND,
        VehicleCommand.of(Map.of(Actuator.HAND_BRAKE, 1.0, Actuator.THROTTLE, 1.0), USUAL));
    assertEquals(0, after(world, 6).speed());
  }

  @ParameterizedTest
  @CsvSource({"REVERSE,1", "GEAR,-1"})
  void reverseGearEngagesAtStandstill(Actuator actuator, double value) {
    World world = new World(with(2, Chassis.USUAL), List.of());
    world.command(0, VehicleCommand.of(Map.of(actuator, value, Actuator.THROTTLE, 1.0), USUAL));
    assertTrue(after(world, 1).speed() > 0, "it rolls on");
    Trace.State state = after(world, 8);
    assertTrue(state.speed() < -5, "it drives backwards");
    assertTrue(state.position() < 0);
  }

  @Test
  void whatStandsBehindIsHitBackwards() {
    Actor behind = Actor.passengerCar(-4.5 - 4.5 - 3, 0, 0);
    World backwards = new World(with(0, Chassis.USUAL), List.of(behind));
    backwards.command(
        0, VehicleCommand.of(Map.of(Actuator.REVERSE, 1.0, Actuator.THROTTLE, 1.0), USUAL));
    backwards.advanceTo(5 * SECOND);
    assertTrue(backwards.impacted());
    assertTrue(backwards.trace().impactSpeed().orElseThrow() > 3);
  }

  @Test
  void neutralGearDoesNotDrive() {
    World world = new World(with(0, Chassis.USUAL), List.of());
    world.command(0, VehicleCommand.of(Map.of(Actuator.GEAR, 0.0, Actuator.THROTTLE, 1.0), USUAL));
    assertEquals(0, after(world, 3).speed());
  }

  @Test
  void dragSlowsAFastVehicleDown() {
    Chassis drag = new Chassis(2.7, 0.6, 3, 0.001, 0, 0);
    EgoVehicle ego = new EgoVehicle(40, 0, 0.3, 9, 0, 3, LidarSettings.USUAL, drag);
    World world = new World(ego, List.of());
    world.command(0, VehicleCommand.drive(1e-9));
    // v' = -c v^2 has the solution v0 / (1 + c v0 t); the ramp of the pedal takes a moment.
    assertEquals(40 / (1 + 0.001 * 40 * 10), after(world, 10).speed(), 0.1);
  }

  @ParameterizedTest
  @CsvSource({
    "STEERING,1.5,steering 1.5",
    "STEERING,NaN,steering NaN",
    "STEERING_ANGLE,-0.7,steering 1.1459155902616465",
    "MANUAL_GEAR_SHIFT,1,manual_gear_shift",
    "ACCELERATION,NaN,acceleration NaN",
    "ACCELERATION,-900,acceleration -900.0",
    "ACCELERATION,-9,''",
    "ACCELERATION,3.1,acceleration 3.1"
  })
  void whatTheVehicleCannotDoIsSaid(Actuator actuator, double value, String ignored) {
    assertEquals(ignored, VehicleCommand.of(Map.of(actuator, value), USUAL).ignored());
  }

  @Test
  void lidarSeesFromWhereTheEgoStandsAndLooks() {
    // A box straight ahead of an ego that looks 10 degrees to the left, its rear 20 m away.
    Road.Place ego = new Road.Place(0, 1, StrictMath.toRadians(10));
    double far = 20;
    Body box = new Body(ego.ahead(far + 0.5), 1, 1, 0, 1.5, 0.8f);
    Lidar lidar = new Lidar(LidarSettings.USUAL, 1);
    byte[] points = lidar.scan(new RoadScene(Road.straight(), ego, List.of(box)));
    java.nio.ByteBuffer data =
        java.nio.ByteBuffer.wrap(points).order(java.nio.ByteOrder.LITTLE_ENDIAN);
    int seen = 0;
    for (int at = 0; at < data.limit(); at += Lidar.POINT_STEP) {
      if (data.getFloat(at + 12) == 0.8f) {
        // its rear, and its side that faces the ego
        assertTrue(data.getFloat(at) > far + 2.2 && data.getFloat(at) < far + 3.6);
        assertEquals(0, data.getFloat(at + 4), 0.7);
        seen++;
      }
    }
    assertTrue(seen > 4, seen + " points");
  }
}

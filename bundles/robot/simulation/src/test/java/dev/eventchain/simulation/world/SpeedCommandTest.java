package dev.eventchain.simulation.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests a vehicle that keeps a commanded speed by itself, as mobile robots do. */
class SpeedCommandTest {

  /** 0.5 m/s2 up, 1 m/s2 down, commands in effect at once that hold for 0.5 s. */
  private static EgoVehicle robot(double speed, double timeout) {
    return robot(speed, timeout, Chassis.USUAL);
  }

  /** A robot that turns on the spot by up to 1.5 rad/s. */
  private static EgoVehicle turning(double speed, double timeout) {
    return robot(speed, timeout, new Chassis(0.4, 0.6, 0.0, 0.0, 0.0, 0.0, 1.5));
  }

  private static EgoVehicle robot(double speed, double timeout, Chassis chassis) {
    EgoVehicle car = new EgoVehicle(speed, 0.0, 0.3, 1.0, 0.5, 0.5, LidarSettings.USUAL, chassis);
    return new EgoVehicle(
        speed,
        0.0,
        car.brakeBuildUp(),
        1.0,
        car.coastingDeceleration(),
        0.5,
        car.lidar(),
        car.chassis(),
        car.shape(),
        0.0,
        timeout);
  }

  private static World world(EgoVehicle robot) {
    return world(robot, false);
  }

  private static World world(EgoVehicle robot, boolean isSteered) {
    HumanDriver driver =
        new HumanDriver(
            new SpeedProfile(robot.speed(), List.of()),
            new LateralProfile(isSteered ? 1 : 0, List.of()),
            isSteered);
    Road road = Road.bend(0, Road.USUAL_LANE_WIDTH);
    return new World(new Situation(robot, driver, road, List.of()), new Trace());
  }

  private static void command(World world, EgoVehicle robot, double speed, double yawRate) {
    world.command(
        world.now(),
        VehicleCommand.of(Map.of(Actuator.SPEED, speed, Actuator.YAW_RATE, yawRate), robot));
  }

  /** It speeds up by 0.5 m/s2 and slows down by 1 m/s2, to the end of which it stands. */
  @ParameterizedTest
  @CsvSource({
    "1.0, 2.0, 0.5, 1.25, 0.5625, 0.5",
    "1.0, 2.0, 4.0, 2.0, 7.0, 0.0",
    "1.0, 0.0, 0.5, 0.5, 0.375, -1.0",
    "1.0, 0.0, 4.0, 0.0, 0.5, 0.0",
    "1.0, -1.0, 4.0, -1.0, -1.5, 0.0",
    "0.0, -1.0, 1.0, -0.5, -0.25, -0.5",
    "1.0, 1.0, 3.0, 1.0, 3.0, 0.0"
  })
  void theSpeedIsReachedAtTheLimits(
      double from, double to, double seconds, double speed, double way, double acceleration) {
    EgoVehicle robot = robot(from, 0.0);
    World world = world(robot);
    command(world, robot, to, 0.0);
    world.advanceTo(World.nanoseconds(seconds));
    assertEquals(speed, world.ego().velocity(), 1e-9);
    assertEquals(way, world.station().along(), 1e-9);
    assertEquals(acceleration, 0.0 - world.trace().end().deceleration(), 1e-9);
  }

  /** Commands until 1 s hold until 1.5 s; then it needs 1 s to stop. */
  @Test
  void itStopsByItselfWithoutCommands() {
    EgoVehicle robot = robot(1.0, 0.5);
    World world = world(robot);
    for (int i = 0; i <= 10; i++) {
      world.advanceTo(World.nanoseconds(i / 10.0));
      command(world, robot, 1.0, 0.0);
    }
    world.advanceTo(World.nanoseconds(1.5));
    assertEquals(1.0, world.egoSpeed(), 1e-9);
    world.advanceTo(World.nanoseconds(2.0));
    assertEquals(0.5, world.egoSpeed(), 1e-9);
    world.advanceTo(World.nanoseconds(5));
    assertEquals(0.0, world.egoSpeed());
    command(world, robot, 1.0, 0.0);
    world.advanceTo(World.nanoseconds(5.4));
    assertEquals(0.2, world.egoSpeed(), 1e-9);
  }

  /** A message on another topic repeats the speed, and is no sign of life of who commands it. */
  @Test
  void onlyANewSpeedCounts() {
    EgoVehicle robot = robot(1.0, 0.5);
    World world = world(robot);
    command(world, robot, 1.0, 0.0);
    for (int i = 1; i <= 30; i++) {
      world.advanceTo(World.nanoseconds(i / 10.0));
      world.command(world.now(), VehicleCommand.of(Map.of(Actuator.SPEED, 1.0), robot, false));
    }
    assertEquals(0.0, world.egoSpeed());
  }

  @Test
  void withoutATimeoutTheLastCommandHolds() {
    EgoVehicle robot = robot(0.0, 0.0);
    World world = world(robot);
    command(world, robot, 1.0, 0.0);
    world.advanceTo(World.nanoseconds(20));
    assertEquals(1.0, world.egoSpeed(), 1e-9);
  }

  /** An eighth of a circle to the left in 2.5 s, forwards and backwards. */
  @ParameterizedTest
  @CsvSource({"1.5", "-1.5"})
  void itTurnsByTheCommandedRate(double speed) {
    EgoVehicle robot = robot(0.0, 0.0);
    World world = world(robot);
    command(world, robot, speed, 0.0);
    world.advanceTo(World.nanoseconds(4));
    command(world, robot, speed, Math.PI / 10);
    world.advanceTo(World.nanoseconds(6.5));
    assertEquals(Math.PI / 4, world.ego().front().heading(), 1e-6);
    assertEquals(Math.PI / 10, world.trace().end().pose().yawRate(), 1e-9);
  }

  /** Its rear axle stays, and its front goes around that. */
  @Test
  void itTurnsOnTheSpot() {
    EgoVehicle robot = turning(0.0, 0.0);
    World world = world(robot);
    command(world, robot, 0.0, Math.PI / 4);
    world.advanceTo(World.nanoseconds(2));
    assertFrom(world, robot, 0.0, 0.0, Math.PI / 2);
    assertEquals(0.0, world.egoSpeed());
    assertEquals(Math.PI / 4, world.trace().end().pose().yawRate(), 1e-12);
  }

  /** With a constant speed v, and a yaw rate w, its axle is on a circle of v / w. */
  @ParameterizedTest
  @CsvSource({"1, 0.5", "-1, 0.5", "1, -0.5", "1, 0.005", "1, 0.0101", "0.1, 1.5"})
  void itDrivesACircle(double speed, double yawRate) {
    EgoVehicle robot = turning(Math.max(0.0, speed), 0.0);
    World world = world(robot);
    double start = 0.0;
    if (speed < 0.0) {
      command(world, robot, speed, 0.0);
      world.advanceTo(World.nanoseconds(2));
      start = -1.0; // by 0.5 m/s2 to -1 m/s
    }
    command(world, robot, speed, yawRate);
    double seconds = 3.0;
    world.advanceTo(world.now() + World.nanoseconds(seconds));
    double angle = yawRate * seconds;
    double radius = speed / yawRate;
    assertFrom(
        world, robot, start + radius * Math.sin(angle), radius * (1 - Math.cos(angle)), angle);
  }

  /**
   * From standstill, with an acceleration a and a yaw rate w, x is the integral of a t cos(w t),
   * and y that of a t sin(w t).
   */
  @Test
  void itSpeedsUpWhileItTurns() {
    EgoVehicle robot = turning(0.0, 0.0);
    World world = world(robot);
    double rate = Math.PI / 4;
    command(world, robot, 5.0, rate);
    world.advanceTo(World.nanoseconds(2));
    double x = 0.5 * (2 / rate - 1 / (rate * rate));
    double y = 0.5 / (rate * rate);
    assertFrom(world, robot, x, y, Math.PI / 2);
    assertEquals(1.0, world.egoSpeed(), 1e-9);
  }

  /** It turns by its limit for 0.5 s, and by nothing after that. */
  @Test
  void itTurnsNoFasterAndNoLongerThanItMay() {
    EgoVehicle robot = turning(0.0, 0.5);
    World world = world(robot);
    command(world, robot, 0.0, 3.0);
    world.advanceTo(World.nanoseconds(2));
    assertFrom(world, robot, 0.0, 0.0, 0.75);
    assertEquals(0.0, world.trace().end().pose().yawRate());
    Map<Actuator, Double> fast = Map.of(Actuator.SPEED, 0.0, Actuator.YAW_RATE, 3.0);
    assertEquals("yaw_rate 3.0 at speed 0.0", VehicleCommand.of(fast, robot).ignored());
    Map<Actuator, Double> slow = Map.of(Actuator.SPEED, 0.0, Actuator.YAW_RATE, -1.5);
    assertEquals("", VehicleCommand.of(slow, robot).ignored());
  }

  /**
   * A robot that stands and turns hits what stands behind or beside it, as fast as its corner goes.
   * Its axle is at -x, and its corners are there to within the size of the post.
   */
  @ParameterizedTest
  @CsvSource({
    "1, -3.30, -0.3, the ego's rear hit post",
    "-1, -3.30, 0.3, the ego's rear hit post",
    "1, 0.5, 1.3, the ego's left side hit post",
    "-1, 0.5, -1.3, the ego's right side hit post"
  })
  void aRobotThatTurnsOnTheSpotHitsOthers(double yawRate, double ahead, double left, String words) {
    EgoVehicle robot = turning(0.0, 0.0);
    double axle = -robot.axleToBumper();
    Actor post =
        new Actor(
            "post",
            ActorKind.PEDESTRIAN,
            new Actor.Size(0.1, 0.1, 0, 1),
            axle + ahead - 0.05,
            0.0,
            new SpeedProfile(0.0, List.of()),
            new LateralProfile(left, List.of()));
    World world = new World(Situation.straight(robot, List.of(post)), new Trace());
    command(world, robot, 0.0, yawRate);
    world.advanceTo(World.nanoseconds(2));
    assertEquals(words, world.trace().impact());
    assertEquals(List.of(), world.trace().fromBehind());
    double radius = Math.hypot(ahead, left);
    assertEquals(radius, world.trace().impactSpeed().orElseThrow(), 0.1);
  }

  /** Its front meets the wall beside the road as fast as it swings, although it stands. */
  @Test
  void aRobotThatTurnsOnTheSpotMeetsTheWallAsFastAsItsFrontMoves() {
    double offset = Road.WALL_DISTANCE - 1.3;
    EgoVehicle robot = robot(0.0, 0.0, new Chassis(0.4, 0.6, 0.0, 0.0, offset, 0.0, 1.5));
    World world = new World(Situation.straight(robot, List.of()), new Trace());
    command(world, robot, 0.0, 1.0);
    world.advanceTo(World.nanoseconds(3));
    assertEquals("the ego left the road", world.trace().impact());
    assertEquals(robot.axleToBumper(), world.trace().impactSpeed().orElseThrow(), 0.1);
  }

  /** Checks how far its rear axle is from where it was, and where its front is then. */
  private static void assertFrom(
      World world, EgoVehicle robot, double along, double across, double heading) {
    Road.Place front = world.ego().front();
    double length = robot.axleToBumper();
    assertEquals(heading, front.heading(), 1e-9);
    assertEquals(along, front.x() + length - length * Math.cos(heading), 1e-8);
    assertEquals(across, front.y() - length * Math.sin(heading), 1e-8);
  }

  /** A driver who is said to steer has the wheel until the software first turns the vehicle. */
  @Test
  void aDriverSteersUntilItTurns() {
    EgoVehicle robot = robot(1.0, 0.0);
    World world = world(robot, true);
    command(world, robot, 1.0, 0.0);
    world.advanceTo(World.nanoseconds(10));
    assertEquals(1.0, world.station().across(), 0.05);
    assertTrue(world.trace().wheelTaken().isEmpty());
    command(world, robot, 1.0, 0.1);
    world.advanceTo(World.nanoseconds(11));
    assertEquals(OptionalLong.of(World.nanoseconds(10)), world.trace().wheelTaken());
    assertEquals(0.1, world.trace().end().pose().yawRate(), 1e-9);
  }

  @Test
  void whatItCannotFollowIsSaid() {
    EgoVehicle robot = robot(1.0, 0.0);
    double most = robot.chassis().tightest();
    assertEquals("", ignored(1.0, most));
    assertEquals("yaw_rate 0.5 at speed 0.0", ignored(0.0, 0.5));
    assertTrue(ignored(Double.NaN, 0.0).contains("NaN"));
    assertFalse(ignored(1.0, Double.NaN).isEmpty());
  }

  private static String ignored(double speed, double yawRate) {
    return VehicleCommand.of(
            Map.of(Actuator.SPEED, speed, Actuator.YAW_RATE, yawRate), robot(1.0, 0.0))
        .ignored();
  }

  @ParameterizedTest
  @CsvSource({
    "THROTTLE, true",
    "BRAKE, true",
    "ACCELERATION, true",
    "GEAR, true",
    "HAND_BRAKE, true",
    "STEERING, false",
    "YAW_RATE, false"
  })
  void aSpeedTakesThePedals(Actuator other, boolean excludes) {
    assertEquals(excludes, Actuator.SPEED.excludes(other));
    assertTrue(Actuator.YAW_RATE.excludes(Actuator.STEERING_ANGLE));
  }
}

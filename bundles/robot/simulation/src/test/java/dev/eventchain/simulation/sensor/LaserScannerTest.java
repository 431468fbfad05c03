package dev.eventchain.simulation.sensor;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests scans in one plane. */
class LaserScannerTest {

  private static final MessageType TYPE =
      MessageCatalog.of(List.of()).find("sensor_msgs/msg/LaserScan").orElseThrow();

  /** From the side of the ego to the wall. */
  private static final float TO_WALL = (float) (Road.WALL_DISTANCE - 0.9);

  private static LaserScanner scanner(double direction, double view, double height, double noise) {
    return new LaserScanner(
        new Mounting(
            OptionalDouble.empty(), OptionalDouble.empty(), StrictMath.toRadians(direction)),
        30,
        0.5,
        StrictMath.toRadians(view / 2),
        StrictMath.toRadians(10),
        height,
        noise);
  }

  private static float[] scan(LaserScanner scanner, World world) {
    MessageValue message = MessageValue.of(TYPE);
    scanner.describe(message, 0.1);
    scanner.scan(world, new SplittableRandom(1), message);
    return (float[]) message.get("ranges");
  }

  private static World world(Actor... actors) {
    return new World(EgoVehicle.withSpeed(0), List.of(actors));
  }

  @Test
  void rayAheadHitsTheRearOfACarAndTheOthersPassIt() {
    float[] ranges = scan(scanner(0, 40, 0.5, 0), world(Actor.passengerCar(20, 0, 0)));
    assertEquals(5, ranges.length);
    assertEquals(20, ranges[2], 1e-5);
    assertEquals(Float.POSITIVE_INFINITY, ranges[1], "the wall is out of range");
  }

  @Test
  void planeAboveSeesNoCarButALorry() {
    LaserScanner above = scanner(0, 10, 2.5, 0);
    assertEquals(
        Float.POSITIVE_INFINITY, scan(above, world(Actor.passengerCar(20, 0, 0)))[0], "over it");
    LaserScanner thin = scanner(0, 20, 2.5, 0);
    assertEquals(20, scan(thin, world(TestActors.standing(ActorKind.LORRY, 20)))[1], 1e-5);
    assertEquals(
        Float.POSITIVE_INFINITY, scan(thin, world(TestActors.standing(ActorKind.BRIDGE, 20)))[1]);
  }

  @Test
  void wallsAreAsideAndWhatFollowsIsBehind() {
    assertEquals(TO_WALL, scan(scanner(90, 20, 0.5, 0), world())[1], 1e-4);
    assertEquals(TO_WALL, scan(scanner(-90, 20, 0.5, 0), world())[1], 1e-4);
    double length = 4.5;
    World followed = world(TestActors.standing(ActorKind.CAR, -12 - 2 * length));
    assertEquals(12, scan(scanner(180, 20, 0.5, 0), followed)[1], 1e-4);
  }

  @Test
  void sensorOnATrailerSeesWhatIsBehindIt() {
    LaserScanner trailer =
        new LaserScanner(
            new Mounting(OptionalDouble.of(-30), OptionalDouble.of(0), Math.PI),
            20,
            0.1,
            StrictMath.toRadians(10),
            StrictMath.toRadians(10),
            0.5,
            0);
    assertEquals(
        10, scan(trailer, world(TestActors.standing(ActorKind.CAR, -30 - 10 - 4.5)))[1], 1e-4);
  }

  @Test
  void whatIsTooNearIsNegativelyInfinite() {
    float[] ranges = scan(scanner(0, 20, 0.5, 0), world(Actor.passengerCar(0.2, 0, 0)));
    assertEquals(Float.NEGATIVE_INFINITY, ranges[1]);
  }

  @Test
  void messageSaysTheGeometryOfItsRays() {
    MessageValue message = MessageValue.of(TYPE);
    LaserScanner scanner = scanner(0, 360, 0.5, 0);
    scanner.describe(message, 0.1);
    assertEquals(36, scanner.rays(), "the last one would be the first one again");
    assertEquals(-Math.PI, message.number("angle_min"), 1e-6);
    assertEquals(StrictMath.toRadians(170), message.number("angle_max"), 1e-6);
    assertEquals(19, scanner(0, 180, 0.5, 0).rays());
    assertEquals(0.1, message.number("scan_time"), 1e-6);
    assertEquals(0.5, message.number("range_min"), 1e-6);
    assertEquals(30, message.number("range_max"), 1e-6);
  }

  @Test
  void noiseFollowsTheSeedAndStaysInRange() {
    LaserScanner noisy = scanner(90, 40, 0.5, 0.1);
    float[] first = scan(noisy, world());
    assertArrayEquals(first, scan(noisy, world()));
    assertTrue(Math.abs(first[2] - TO_WALL) > 1e-4 && Math.abs(first[2] - TO_WALL) < 1);
  }
}

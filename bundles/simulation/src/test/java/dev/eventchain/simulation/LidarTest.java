package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LidarTest {

  private static final EgoVehicle EGO = EgoVehicle.withSpeed(10);

  private record Point(float x, float y, float z) {}

  private static List<Point> scan(EgoVehicle ego, long seed, TargetVehicle... targets) {
    World world = new World(ego, List.of(targets));
    ByteBuffer data =
        ByteBuffer.wrap(
                new Lidar(ego, seed).scan(RoadScene.boxes(world), world.moment().end().pose()))
            .order(ByteOrder.LITTLE_ENDIAN);
    List<Point> points = new ArrayList<>();
    for (int at = 0; at < data.limit(); at += Lidar.POINT_STEP) {
      points.add(new Point(data.getFloat(at), data.getFloat(at + 4), data.getFloat(at + 8)));
    }
    return points;
  }

  /** Points in the way of the ego, not on the road. */
  private static List<Point> obstacles(List<Point> points) {
    return points.stream()
        .filter(point -> Math.abs(point.y()) < 1.2 && point.z() > 0.3 - EGO.lidarAboveRoad())
        .toList();
  }

  @Test
  void scanOfTheEmptyRoadHasAtLeastTwoThousandPointsAndNoObstacle() {
    List<Point> points = scan(EGO, 1);
    assertTrue(points.size() >= 2000, () -> points.size() + " points");
    assertEquals(List.of(), obstacles(points));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.2, 0.5, 1, 2, 3.3, 5, 8, 13, 21, 34, 60, 80})
  void nearestObstacleIsTheRearOfTheVehicleAhead(double gap) {
    List<Point> obstacles = obstacles(scan(EGO, 1, TargetVehicle.passengerCar(gap, 0, 0)));
    DoubleSummaryStatistics ways = obstacles.stream().mapToDouble(Point::x).summaryStatistics();
    assertEquals(gap + EGO.lidarBehindBumper(), ways.getMin(), 0.05);
    assertTrue(ways.getCount() >= 6, () -> ways.getCount() + " points");
  }

  @Test
  void vehicleSixtyMetresAheadReturnsManyPoints() {
    List<Point> points = obstacles(scan(EGO, 1, TargetVehicle.passengerCar(60, 0, 0)));
    assertTrue(points.size() >= 12, () -> points.size() + " points");
  }

  @Test
  void vehicleInTheNextLaneIsSeenBesideTheCorridor() {
    TargetVehicle beside = TargetVehicle.passengerCar(20, 0, 3.5);
    List<Point> points = scan(EGO, 1, beside);
    assertEquals(List.of(), obstacles(points));
    assertTrue(
        points.stream()
            .anyMatch(point -> Math.abs(point.y() - 3) < 0.5 && Math.abs(point.x() - 22.4) < 0.1));
  }

  @Test
  void vehicleHidesWhatIsBehindIt() {
    TargetVehicle truck = new TargetVehicle(10, 0, 0, 2.5, 4, 10, Double.POSITIVE_INFINITY, 0);
    TargetVehicle hidden = TargetVehicle.passengerCar(30, 0, 0);
    assertEquals(scan(EGO, 1, truck), scan(EGO, 1, truck, hidden));
  }

  @Test
  void sameSeedGivesTheSameBytesAndAnotherSeedOthers() {
    World world = new World(EGO, List.of(TargetVehicle.passengerCar(30, 0, 0)));
    byte[] first = new Lidar(EGO, 7).scan(RoadScene.boxes(world), world.moment().end().pose());
    assertArrayEquals(
        first, new Lidar(EGO, 7).scan(RoadScene.boxes(world), world.moment().end().pose()));
    assertFalse(
        Arrays.equals(
            first, new Lidar(EGO, 8).scan(RoadScene.boxes(world), world.moment().end().pose())));
  }

  @Test
  void rangesHaveTheNoiseOfTheScenario() {
    EgoVehicle ego = new EgoVehicle(10, 0.2, 0.3, 9, 0.5, 3, 2.4, 2.4, 0.02, Chassis.USUAL);
    EgoVehicle silent = new EgoVehicle(10, 0.2, 0.3, 9, 0.5, 3, 2.4, 2.4, 0, Chassis.USUAL);
    List<Point> noisy = scan(ego, 3);
    List<Point> exact = scan(silent, 3);
    double squares = 0;
    for (int i = 0; i < exact.size(); i++) {
      double error = range(noisy.get(i)) - range(exact.get(i));
      squares += error * error;
    }
    assertEquals(0.02, Math.sqrt(squares / exact.size()), 0.001);
  }

  private static double range(Point point) {
    return Math.hypot(point.x(), Math.hypot(point.y(), point.z()));
  }
}

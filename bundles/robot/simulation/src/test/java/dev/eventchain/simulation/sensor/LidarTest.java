package dev.eventchain.simulation.sensor;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.Chassis;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.LidarSettings;
import dev.eventchain.simulation.world.SpeedProfile;
import dev.eventchain.simulation.world.World;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LidarTest {

  private static final EgoVehicle EGO = EgoVehicle.withSpeed(10);

  private record Point(float x, float y, float z) {}

  private static List<Point> scan(EgoVehicle ego, long seed, Actor... targets) {
    World world = new World(ego, List.of(targets));
    ByteBuffer data =
        ByteBuffer.wrap(new Lidar(ego.lidar(), seed).scan(RoadScene.of(world)))
            .order(ByteOrder.LITTLE_ENDIAN);
    List<Point> points = new ArrayList<>();
    for (int at = 0; at < data.limit(); at += Lidar.POINT_STEP) {
      points.add(new Point(data.getFloat(at), data.getFloat(at + 4), data.getFloat(at + 8)));
    }
    return points;
  }

  /** Returns the points in the way of the ego, not on the road. */
  private static List<Point> obstacles(List<Point> points) {
    return points.stream()
        .filter(point -> Math.abs(point.y()) < 1.2 && point.z() > 0.3 - EGO.lidar().aboveRoad())
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
    List<Point> obstacles = obstacles(scan(EGO, 1, Actor.passengerCar(gap, 0, 0)));
    DoubleSummaryStatistics ways = obstacles.stream().mapToDouble(Point::x).summaryStatistics();
    assertEquals(gap + EGO.lidar().behindBumper(), ways.getMin(), 0.05);
    assertTrue(ways.getCount() >= 6, () -> ways.getCount() + " points");
  }

  @Test
  void vehicleSixtyMetresAheadReturnsManyPoints() {
    List<Point> points = obstacles(scan(EGO, 1, Actor.passengerCar(60, 0, 0)));
    assertTrue(points.size() >= 8, () -> points.size() + " points");
  }

  @Test
  void vehicleInTheNextLaneIsSeenBesideTheCorridor() {
    Actor beside = Actor.passengerCar(20, 0, 3.5);
    List<Point> points = scan(EGO, 1, beside);
    assertEquals(List.of(), obstacles(points));
    assertTrue(
        points.stream()
            .anyMatch(point -> Math.abs(point.y() - 3) < 0.5 && Math.abs(point.x() - 22.4) < 0.1));
  }

  @Test
  void vehicleHidesWhatIsBehindIt() {
    Actor truck = standing(ActorKind.LORRY, 10);
    Actor hidden = Actor.passengerCar(30, 0, 0);
    assertEquals(scan(EGO, 1, truck), scan(EGO, 1, truck, hidden));
  }

  @Test
  void sameSeedGivesTheSameBytesAndAnotherSeedOthers() {
    World world = new World(EGO, List.of(Actor.passengerCar(30, 0, 0)));
    byte[] first = new Lidar(EGO.lidar(), 7).scan(RoadScene.of(world));
    assertArrayEquals(first, new Lidar(EGO.lidar(), 7).scan(RoadScene.of(world)));
    assertFalse(Arrays.equals(first, new Lidar(EGO.lidar(), 8).scan(RoadScene.of(world))));
  }

  @Test
  void rangesHaveTheNoiseOfTheScenario() {
    List<Point> noisy = scan(with(0.02, 0), 3);
    List<Point> exact = scan(with(0, 0), 3);
    double squares = 0;
    for (int i = 0; i < exact.size(); i++) {
      double error = range(noisy.get(i)) - range(exact.get(i));
      squares += error * error;
    }
    assertEquals(0.02, Math.sqrt(squares / exact.size()), 0.001);
  }

  private static EgoVehicle with(double noise, double dropout) {
    return with(new LidarSettings(2.4, 2.4, noise, dropout, 0.5));
  }

  private static EgoVehicle with(LidarSettings settings) {
    return new EgoVehicle(10, 0.2, 0.3, 9, 0.5, 3, settings, Chassis.USUAL);
  }

  private static Actor standing(ActorKind kind, double gap) {
    SpeedProfile still = new SpeedProfile(0, List.of());
    LateralProfile middle = new LateralProfile(0, List.of());
    return new Actor(kind.id(), kind, kind.size(), gap, 0, still, middle);
  }

  @Test
  void aPartOfTheRaysReturnsNothing() {
    int all = scan(with(0, 0), 3).size();
    int most = scan(with(0, 0.2), 3).size();
    assertEquals(0.8, (double) most / all, 0.03);
  }

  @ParameterizedTest
  @CsvSource({"1, 0.5", "0.5, 1", "2, 0.25"})
  void theNumberOfPointsGoesWithTheStepOfTheRays(double step, double part) {
    int usual = scan(with(0, 0), 3).size();
    int points = scan(with(new LidarSettings(2.4, 2.4, 0, 0, step)), 3).size();
    assertEquals(part, (double) points / usual, 0.02);
  }

  @Test
  void whatHangsAboveTheRoadIsSeenWithItsLowerSide() {
    List<Point> points = scan(EGO, 1, standing(ActorKind.BRIDGE, 40));
    DoubleSummaryStatistics above =
        points.stream()
            .filter(point -> point.z() > 0 && Math.abs(point.y()) < 5)
            .mapToDouble(point -> point.z() + EGO.lidar().aboveRoad())
            .summaryStatistics();
    assertTrue(above.getCount() > 40, above::toString);
    assertTrue(above.getMin() > 4.65 && above.getMin() < 5.1, above::toString);
    assertTrue(above.getMax() < 6.1, above::toString);
    assertEquals(List.of(), obstacles(points).stream().filter(it -> it.z() < 0).toList());
  }

  private static double range(Point point) {
    return Math.hypot(point.x(), Math.hypot(point.y(), point.z()));
  }
}

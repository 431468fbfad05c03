package dev.eventchain.roads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LanePathTest {

  private static final RoadNetwork CROSSING = Networks.read("crossing");
  private static final RoadNetwork LEAVING = Networks.read("leaving");

  private static List<String> roads(LanePath path) {
    return path.starts().stream().map(LanePosition::road).distinct().toList();
  }

  @Test
  void pathGoesStraightThroughACrossing() {
    LanePath path = CROSSING.path(new LanePosition("0", -1, 10, 0), 5, 200).orElseThrow();
    assertEquals(List.of("0", "201", "2"), roads(path));
    assertEquals(200, path.length(), 1e-9);
    assertEquals(10, path.origin(), 1e-9);
    assertEquals(0, path.curvature(95));
    assertTrue(path.isAlongS(90));
    assertFalse(path.isAlongS(130));
    assertEquals(new LanePosition("2", 1, 70, 0), path.lanePosition(130));
  }

  @Test
  void pathBackwardsComesWhereThePathForwardsCameFrom() {
    LanePath path = CROSSING.path(new LanePosition("2", 1, 70, 0), 100, 5).orElseThrow();
    assertEquals(List.of("0", "201", "2"), roads(path));
    assertEquals(130, path.origin(), 1e-9);
  }

  @Test
  void againstTrafficThePathIsTheSameFromItsEnd() {
    LanePosition position = new LanePosition("0", -1, 30, 0);
    LanePath with = CROSSING.path(position, true, 1, 1).orElseThrow();
    LanePath against = CROSSING.path(position, false, 1, 1).orElseThrow();
    assertEquals(with.length(), against.origin() + with.origin(), 1e-9);
    Pose there = with.pose(20, 1);
    Pose back = against.pose(with.length() - 20, -1);
    assertEquals(there.x(), back.x(), 1e-9);
    assertEquals(there.y(), back.y(), 1e-9);
  }

  @Test
  void pathFollowsARouteAndTurns() {
    LanePosition from = new LanePosition("0", -1, 10, 0);
    Route route = CROSSING.route(List.of(from, new LanePosition("1", 1, 20, 0))).orElseThrow();
    assertEquals(List.of("0", "200", "1"), route.legs().stream().map(Route.Leg::road).toList());
    double through = CROSSING.road("200").orElseThrow().length();
    assertEquals(70 + through + 60, route.length(), 1e-9);
    LanePath path = CROSSING.path(from, route, 0).orElseThrow();
    assertEquals(List.of("0", "200", "1"), roads(path));
    double most = 0;
    for (double along = 0; along < path.length(); along += 0.5) {
      most = Math.max(most, Math.abs(path.curvature(along)));
    }
    assertTrue(most > 0.04, "curvature " + most);
  }

  @Test
  void routeTurnsOnlyWhereTrafficDoes() {
    LanePosition against = new LanePosition("1", -1, 20, 0);
    assertEquals(
        Optional.empty(), CROSSING.route(List.of(new LanePosition("0", -1, 10, 0), against)));
  }

  @Test
  void routeGoesOverWaypoints() {
    LanePosition from = new LanePosition("1", -1, 100, 0);
    RoadNetwork network = LEAVING;
    Route route =
        network
            .route(
                List.of(from, new LanePosition("1", -2, 280, 0), new LanePosition("3", -1, 50, 0)))
            .orElseThrow();
    assertEquals(
        List.of(new Route.Leg("1", true, 100, 300), new Route.Leg("3", true, 0, 50)), route.legs());
    assertEquals(
        Optional.empty(),
        network.route(List.of(new LanePosition("1", -1, 100, 0), new LanePosition("9", 1, 0, 0))));
  }

  @Test
  void pathAlongARouteChangesLanesSmoothly() {
    LanePosition from = new LanePosition("1", -2, 100, 0);
    LanePosition to = new LanePosition("3", -1, 50, 0);
    Route route = LEAVING.route(List.of(from, to)).orElseThrow();
    LanePath path = LEAVING.path(from, route, 0).orElseThrow();
    assertEquals(List.of("1", "3"), roads(path));
    requireContinuous(path);
    double last = path.heading(0);
    for (double along = 0; along < path.length(); along += 0.1) {
      double turned = Math.IEEEremainder(path.heading(along) - last, 2 * Math.PI);
      assertEquals(0, turned, 0.01, "at " + along);
      last = path.heading(along);
    }
    Pose target = LEAVING.pose(to).orElseThrow();
    double across = path.station(target.x(), target.y(), path.length()).across();
    assertEquals(0, across, 1e-6);
  }

  @Test
  void routesLeaveAndJoinARoadBetweenItsEnds() {
    RoadNetwork network = Networks.read("side-street");
    double turn = 10 * Math.PI;
    LanePosition from = new LanePosition("1", -1, 10, 0);
    Route off = network.route(List.of(from, new LanePosition("3", -1, 20, 0))).orElseThrow();
    assertEquals(
        List.of(
            new Route.Leg("1", true, 10, 100),
            new Route.Leg("2", true, 0, turn),
            new Route.Leg("3", true, 0, 20)),
        off.legs());
    LanePath path = network.path(from, off, 0).orElseThrow();
    assertEquals(List.of("1", "2", "3"), roads(path));
    requireContinuous(path);
    LanePosition back = new LanePosition("3", 1, 30, 0);
    Route onto = network.route(List.of(back, new LanePosition("1", -1, 180, 0))).orElseThrow();
    assertEquals(
        List.of(
            new Route.Leg("3", false, 30, 0),
            new Route.Leg("5", true, 0, turn),
            new Route.Leg("1", true, 140, 180)),
        onto.legs());
    requireContinuous(network.path(back, onto, 0).orElseThrow());
    LanePosition oncoming = new LanePosition("1", 1, 190, 0);
    assertEquals(
        Optional.empty(), network.route(List.of(oncoming, new LanePosition("3", -1, 20, 0))));
  }

  @Test
  void pathsStayOnARoadThatOthersLeave() {
    RoadNetwork network = Networks.read("side-street");
    LanePath path = network.path(new LanePosition("1", -1, 80, 0), 70, 100).orElseThrow();
    assertEquals(List.of("1"), roads(path));
    assertEquals(3, network.road("1").orElseThrow().sections().size());
    assertEquals(200, path.length(), 1e-9);
    assertEquals(
        new LanePosition("1", -1, 150, 0),
        network.relative(new LanePosition("1", -1, 80, 0), 0, 70).orElseThrow());
  }

  @ParameterizedTest
  @CsvSource({
    "elementS=\"100\", elementS=\"201\", 'Road `1` has no place s = 201.0.'",
    "elementId=\"1\" elementS=\"140\", elementId=\"7\" elementS=\"140\", There is no road `7`.",
    "laneLink from=\"-1\", laneLink from=\"-2\", 'Road `1` has no lane -2 at s = 100.0.'",
  })
  void placesThatRoadsLeaveAreThere(String right, String wrong, String message) {
    SourceText text = SourceText.read(Networks.FOLDER.resolve("side-street.xodr"));
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () ->
                RoadNetwork.parse(SourceText.of("wrong.xodr", text.text().replace(right, wrong))));
    assertEquals("road.link", refused.diagnostics().get(0).id());
    assertEquals(message, refused.diagnostics().get(0).message());
  }

  private static void requireContinuous(LanePath path) {
    double step = 0.25;
    Pose last = path.pose(0, 0);
    for (double along = step; along < path.length(); along += step) {
      Pose next = path.pose(along, 0);
      double moved = Math.hypot(next.x() - last.x(), next.y() - last.y());
      assertEquals(step, moved, 0.01, path.starts() + " at " + along);
      last = next;
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"curves", "parametric", "crossing", "leaving", "tilted"})
  void pathsFromAllLanesAreContinuous(String name) {
    RoadNetwork network = Networks.read(name);
    int paths = 0;
    for (Road road : network.roads()) {
      for (LaneSection section : road.sections()) {
        for (int lane : road.laneIds(section.start())) {
          LanePosition position = new LanePosition(road.id(), lane, section.start(), 0);
          requireContinuous(network.path(position, 30, 60).orElseThrow());
          paths++;
        }
      }
    }
    assertTrue(paths > 3);
  }

  @Test
  void pathGoesOnStraightBeyondItsEnds() {
    LanePath path = LEAVING.path(new LanePosition("3", -1, 90, 0), 0, 10).orElseThrow();
    Pose end = path.pose(path.length(), 0);
    Pose beyond = path.pose(path.length() + 10, 2);
    LanePath.Station station = path.station(beyond.x(), beyond.y(), path.length());
    assertEquals(10, station.along() - path.length(), 1e-9);
    assertEquals(2, station.across(), 1e-9);
    assertEquals(end.heading(), beyond.heading());
    assertEquals(0, path.curvature(path.length() + 1));
    Pose before = path.pose(-5, 0);
    assertEquals(-5, path.station(before.x(), before.y(), 0).along(), 1e-9);
  }

  @Test
  void positionsThatAreNotThereHaveNoPath() {
    for (LanePosition none :
        List.of(
            new LanePosition("7", -1, 0, 0),
            new LanePosition("0", -2, 0, 0),
            new LanePosition("0", 0, 0, 0),
            new LanePosition("0", -1, 81, 0),
            new LanePosition("0", -1, Double.NaN, 0))) {
      assertEquals(Optional.empty(), CROSSING.path(none, 0, 1), none.toString());
      assertEquals(Optional.empty(), CROSSING.relative(none, 0, 1), none.toString());
    }
  }

  @Test
  void lanesAreCountedWithoutTheOneInTheMiddle() {
    LanePosition from = new LanePosition("1", -2, 10, 0.5);
    assertEquals(Optional.of(new LanePosition("1", 1, 10, 0.5)), LEAVING.relative(from, 2, 0));
    assertEquals(Optional.of(new LanePosition("1", -1, 5, 0.5)), LEAVING.relative(from, 1, -5));
    LanePosition left = new LanePosition("1", 1, 10, 0);
    assertEquals(Optional.of(new LanePosition("1", -2, 30, 0)), LEAVING.relative(left, -2, 20));
    assertEquals(Optional.empty(), LEAVING.relative(from, 3, 0));
    assertEquals(Optional.empty(), LEAVING.relative(from, 0, -11));
  }

  @Test
  void distancesGoOverLinksAndLeftStaysLeft() {
    LanePosition from = new LanePosition("0", -1, 70, -0.5);
    assertEquals(
        Optional.of(new LanePosition("201", -1, 10, -0.5)), CROSSING.relative(from, 0, 20));
    // Road 2 leads to the crossing, so s runs the other way there.
    assertEquals(Optional.of(new LanePosition("2", 1, 70, 0.5)), CROSSING.relative(from, 0, 60));
    assertEquals(Optional.of(new LanePosition("2", -1, 70, 0.5)), CROSSING.relative(from, 1, 60));
  }

  @Test
  void whereTheOwnLaneEndsTheOtherOneIsFollowed() {
    LanePosition ramp = new LanePosition("1", -3, 290, 0);
    assertEquals(Optional.of(new LanePosition("3", -1, 10, 0)), LEAVING.relative(ramp, 0, 20));
    assertEquals(Optional.of(new LanePosition("2", -2, 10, 0)), LEAVING.relative(ramp, 1, 20));
  }
}

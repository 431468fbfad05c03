package dev.eventchain.openscenario.storyboard;

import static dev.eventchain.openscenario.storyboard.Scenarios.car;
import static dev.eventchain.openscenario.storyboard.Scenarios.placed;
import static dev.eventchain.openscenario.storyboard.Scenarios.privately;
import static dev.eventchain.openscenario.storyboard.Scenarios.run;
import static dev.eventchain.openscenario.storyboard.Scenarios.scenario;
import static dev.eventchain.openscenario.storyboard.Scenarios.state;
import static dev.eventchain.openscenario.storyboard.Scenarios.teleport;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RouteSides;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests where positions are. Lanes are 3.5 m wide, the road goes along the x axis. */
class PositionTest {

  private static StoryboardRun other(String position) {
    // The other one comes first, so that it has to wait.
    return run(
        scenario(
            car("Other") + car("Ego") + car("Oncoming"),
            privately("Other", teleport(position))
                + placed("Ego", -1, 100, 10)
                + placed("Oncoming", 1, 400, 10),
            ""));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<WorldPosition x='7' y='3' h='0.5'/> | 7 | 3 | 0.5",
        "<WorldPosition x='7' y='3'/> | 7 | 3 | 0",
        "<RelativeWorldPosition entityRef='Oncoming' dx='7' dy='1'/> | 407 | 2.75 | 3.141592654",
        "<RelativeObjectPosition entityRef='Oncoming' dx='7' dy='1'/> | 393 | 0.75 | 3.141592654",
        "<RelativeObjectPosition entityRef='Ego' dx='7' dy='1'><Orientation h='0.2'/>"
            + "</RelativeObjectPosition> | 107 | -0.75 | 0.2",
        "<RoadPosition roadId='1' s='50' t='2'/> | 50 | 2 | 0",
        "<RelativeRoadPosition entityRef='Ego' ds='5' dt='1'/> | 105 | -0.75 | 0",
        "<LanePosition roadId='1' laneId='-2' s='50' offset='0.5'/> | 50 | -4.75 | 0",
        "<LanePosition roadId='1' laneId='2' s='50' offset='0.5'/> | 50 | 5.75 | 3.141592654",
        "<LanePosition roadId='1' laneId='2' s='50'><Orientation type='relative' h='0.1'/>"
            + "</LanePosition> | 50 | 5.25 | -3.041592654",
        "<LanePosition roadId='1' laneId='2' s='50'><Orientation type='absolute' h='0.1'/>"
            + "</LanePosition> | 50 | 5.25 | 0.1",
        "<RelativeLanePosition entityRef='Ego' dLane='0' ds='30' offset='0.3'/>"
            + " | 130 | -1.45 | 0",
        "<RelativeLanePosition entityRef='Ego' dLane='-1' ds='-30'/> | 70 | -5.25 | 0",
        "<RelativeLanePosition entityRef='Ego' dLane='1' dsLane='30'/>"
            + " | 130 | 1.75 | 3.141592654",
        "<RelativeLanePosition entityRef='Oncoming' dLane='-1' ds='30' offset='0.5'/>"
            + " | 370 | 4.75 | 3.141592654",
      })
  void isWhereThePositionSays(String position, double x, double y, double heading) {
    Pose pose = state(other(position), "Other").pose();
    assertEquals(x, pose.x(), 1e-9);
    assertEquals(y, pose.y(), 1e-9);
    assertEquals(heading, pose.heading(), 1e-9);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<RoadPosition roadId='7' s='50' t='2'/> | There is no road '7'.",
        "<RoadPosition roadId='1' s='2001' t='2'/>"
            + " | Road '1' is 2000.0 m long; s = 2001.0 m is not on it.",
        "<LanePosition roadId='1' laneId='3' s='50'/>"
            + " | Road '1' has no lane 3 at s = 50.0 m; it has [2, 1, -1, -2].",
        "<LanePosition roadId='1' laneId='left' s='50'/> | 'left' is not the number of a lane.",
        "<RelativeLanePosition entityRef='Ego' dLane='-2' ds='30'/>"
            + " | There is no lane -2 to the left of the entity's.",
        "<RelativeLanePosition entityRef='Ego' dLane='0' ds='-101'/>"
            + " | The road ends before -101.0 m from the entity.",
        "<GeoPosition latitudeDeg='1' longitudeDeg='1'/>"
            + " | A GeoPosition needs the geoReference of the road network: there is none.",
      })
  void refusesWhatIsNowhere(String position, String message) {
    Diagnostic finding =
        assertThrows(DiagnosticException.class, () -> other(position)).diagnostics().get(0);
    assertEquals("storyboard.place.none", finding.id());
    assertEquals(message, finding.message());
  }

  @Test
  void refusesEntitiesRelativeToEachOther() {
    String init =
        privately("Ego", teleport("<RelativeLanePosition entityRef='Other' dLane='0' ds='1'/>"))
            + privately(
                "Other", teleport("<RelativeLanePosition entityRef='Ego' dLane='0' ds='1'/>"));
    Diagnostic finding =
        assertThrows(
                DiagnosticException.class, () -> run(scenario(car("Ego") + car("Other"), init, "")))
            .diagnostics()
            .get(0);
    assertEquals("storyboard.init.circle", finding.id());
    assertEquals("Ego and Other are placed relative to each other.", finding.message());
  }

  /** Two routes of 350 m: along the x axis from 50 m on, and back from 400 m on. */
  private static String onRoute(boolean forward, String orientation, String place) {
    String lane = "<LanePosition roadId='1' laneId='%d' s='%d'/>";
    String first = forward ? lane.formatted(-1, 50) : lane.formatted(1, 400);
    String last = forward ? lane.formatted(-2, 400) : lane.formatted(2, 50);
    String waypoint = "<Waypoint routeStrategy='shortest'><Position>%s</Position></Waypoint>";
    return "<RoutePosition><RouteRef><Route closed='false' name='r'>"
        + waypoint.formatted(first)
        + waypoint.formatted(last)
        + "</Route></RouteRef>"
        + orientation
        + "<InRoutePosition>"
        + place
        + "</InRoutePosition></RoutePosition>";
  }

  private static StoryboardRun onRoute(
      boolean forward, String place, Optional<RouteSides> routeSides) {
    String turned = "<Orientation type='relative' h='0.1'/>";
    String init =
        privately("Other", teleport(onRoute(forward, turned, place))) + placed("Ego", -1, 900, 10);
    return run(scenario(car("Other") + car("Ego"), init, ""), Scenarios.ROAD, routeSides);
  }

  @ParameterizedTest
  @CsvSource({
    "true, road, -2, 0.5, 150, -4.75",
    "true, route, -2, 0.5, 150, -4.75",
    "false, road, 2, 0.5, 300, 5.75",
    "false, route, -2, 0.5, 300, 4.75",
    "false, road, -2, 0.5, 300, -4.75",
    "false, route, 2, 0.5, 300, -5.75",
  })
  void lanesOnRoutesAreOnEitherSide(
      boolean forward, String sides, int lane, double offset, double x, double y) {
    String place =
        "<FromLaneCoordinates pathS='100' laneId='" + lane + "' laneOffset='" + offset + "'/>";
    StoryboardRun run = onRoute(forward, place, RouteSides.of(sides));
    Pose pose = state(run, "Other").pose();
    assertEquals(x, pose.x(), 1e-9);
    assertEquals(y, pose.y(), 1e-9);
    double route = forward ? 0 : -Math.PI;
    assertEquals(route + 0.1, pose.heading(), 1e-9);
    assertEquals(List.of(), run.findings());
    assertEquals(y < 0, state(run, "Other").road().orElseThrow().lane() < 0);
  }

  @Test
  void distancesBesideRoutesAreOnEitherSide() {
    String place = "<FromRoadCoordinates pathS='350' t='3'/>";
    assertEquals(
        3, state(onRoute(false, place, Optional.of(RouteSides.ROAD)), "Other").pose().y(), 1e-9);
    StoryboardRun usual = onRoute(false, place, Optional.empty());
    assertEquals(-3, state(usual, "Other").pose().y(), 1e-9);
    assertEquals(50, state(usual, "Other").pose().x(), 1e-9);
    assertEquals("storyboard.route.side", usual.findings().get(0).id());
    for (String same : List.of("pathS='350' t='0'", "pathS='0' t='0'")) {
      String middle = "<FromRoadCoordinates " + same + "/>";
      assertEquals(List.of(), onRoute(false, middle, Optional.empty()).findings());
    }
    assertEquals(List.of(), onRoute(true, place, Optional.empty()).findings());
  }

  @Test
  void placesOfOthersAreOnTheirRoute() {
    String here = "<FromCurrentEntity entityRef='Oncoming'/>";
    Pose pose = state(other(onRoute(false, "", here)), "Other").pose();
    assertEquals(400, pose.x(), 1e-9);
    assertEquals(1.75, pose.y(), 1e-9);
    assertEquals(-1, Math.cos(pose.heading()), 1e-9);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "true | <FromRoadCoordinates pathS='350.5' t='0'/>"
            + " | The route is 350.0 m long; pathS = 350.5 m is not on it.",
        "true | <FromRoadCoordinates pathS='-1' t='0'/>"
            + " | The route is 350.0 m long; pathS = -1.0 m is not on it.",
        "false | <FromLaneCoordinates pathS='1' laneId='-3'/>"
            + " | Road '1' has no lane 3 at s = 399.0 m; it has [2, 1, -1, -2].",
        "true | <FromCurrentEntity entityRef='Ego'/> | 'Ego' is not on the route.",
      })
  void refusesWhatIsOnNoRoute(boolean forward, String place, String message) {
    Diagnostic finding =
        assertThrows(DiagnosticException.class, () -> onRoute(forward, place, Optional.empty()))
            .diagnostics()
            .get(0);
    assertEquals("storyboard.place.none", finding.id());
    assertEquals(message, finding.message());
  }

  @Test
  void refusesRoutesAgainstTraffic() {
    String place = onRoute(true, "", "<FromRoadCoordinates pathS='1' t='0'/>");
    String against = place.replace("laneId='-1' s='50'", "laneId='-1' s='500'");
    Diagnostic finding =
        assertThrows(DiagnosticException.class, () -> other(against)).diagnostics().get(0);
    assertEquals(
        "No way leads over the waypoints of the route in the direction of traffic.",
        finding.message());
  }

  /** A line of 50 m from (100, 0) by (3, 4), whose ends have another orientation or none. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'' | 20 | 0 | 112 | 16 | 0.927295218",
        "'' | 20 | 5 | 108 | 19 | 0.927295218",
        "h='0' | 20 | 5 | 108 | 19 | 0.927295218",
        "h='0' | 50 | -5 | 134 | 37 | 0.927295218",
        "'' | 0 | -50 | 140 | -30 | 0.927295218",
      })
  void trajectoriesHaveCoordinates(
      String orientation, double s, double t, double x, double y, double heading) {
    String vertex = "<Vertex><Position><WorldPosition x='%d' y='%d' %s/></Position></Vertex>";
    String position =
        "<TrajectoryPosition s='"
            + s
            + "' t='"
            + t
            + "'><TrajectoryRef><Trajectory name='t' closed='false'><Shape><Polyline>"
            + vertex.formatted(100, 0, orientation)
            + vertex.formatted(130, 40, orientation)
            + "</Polyline></Shape></Trajectory></TrajectoryRef></TrajectoryPosition>";
    Pose pose = state(other(position), "Other").pose();
    assertEquals(x, pose.x(), 1e-9);
    assertEquals(y, pose.y(), 1e-9);
    assertEquals(heading, pose.heading(), 1e-9);
  }
}

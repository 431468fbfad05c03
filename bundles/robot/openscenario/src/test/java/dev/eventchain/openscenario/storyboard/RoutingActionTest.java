package dev.eventchain.openscenario.storyboard;

import static dev.eventchain.openscenario.storyboard.Scenarios.after;
import static dev.eventchain.openscenario.storyboard.Scenarios.car;
import static dev.eventchain.openscenario.storyboard.Scenarios.changes;
import static dev.eventchain.openscenario.storyboard.Scenarios.event;
import static dev.eventchain.openscenario.storyboard.Scenarios.placed;
import static dev.eventchain.openscenario.storyboard.Scenarios.played;
import static dev.eventchain.openscenario.storyboard.Scenarios.privately;
import static dev.eventchain.openscenario.storyboard.Scenarios.run;
import static dev.eventchain.openscenario.storyboard.Scenarios.scenario;
import static dev.eventchain.openscenario.storyboard.Scenarios.speed;
import static dev.eventchain.openscenario.storyboard.Scenarios.state;
import static dev.eventchain.openscenario.storyboard.Scenarios.story;
import static dev.eventchain.openscenario.storyboard.Scenarios.teleport;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests trajectories and routes. */
class RoutingActionTest {

  private static final double EXACT = 1e-6;

  private static final String NONE = "<None/>";

  private static String vertex(double x, double y, String time) {
    return "<Vertex "
        + time
        + "><Position><WorldPosition x='"
        + x
        + "' y='"
        + y
        + "'/></Position></Vertex>";
  }

  private static final String CORNER =
      "<Polyline>" + vertex(0, 0, "") + vertex(30, 0, "") + vertex(30, 40, "") + "</Polyline>";

  private static final String TIMED =
      "<Polyline>"
          + vertex(0, 0, "time='0'")
          + vertex(30, 0, "time='2'")
          + vertex(30, 40, "time='6'")
          + "</Polyline>";

  private static String follow(String shape, String timing, String more) {
    return "<PrivateAction><RoutingAction><FollowTrajectoryAction "
        + more
        + "><Trajectory name='t' closed='"
        + more.contains("closed")
        + "'><Shape>"
        + shape
        + "</Shape></Trajectory><TimeReference>"
        + timing
        + "</TimeReference><TrajectoryFollowingMode followingMode='position'/>"
        + "</FollowTrajectoryAction></RoutingAction></PrivateAction>";
  }

  private static String timing(String domain, double offset, double scale) {
    return "<Timing domainAbsoluteRelative='"
        + domain
        + "' offset='"
        + offset
        + "' scale='"
        + scale
        + "'/>";
  }

  private static StoryboardRun ego(String action) {
    return run(
        scenario(
            car("Ego"), placed("Ego", -1, 100, 10), story("Ego", event("E", action, after(1)))));
  }

  private static void assertAt(double x, double y, EntityState state) {
    assertEquals(x, state.pose().x(), EXACT);
    assertEquals(y, state.pose().y(), EXACT);
  }

  @Test
  void followsLinesWithItsOwnSpeed() {
    StoryboardRun run = ego(follow(CORNER, NONE, ""));
    assertAt(0, 0, state(played(run, 1), "Ego"));
    assertAt(20, 0, state(played(run, 3), "Ego"));
    assertAt(30, 20, state(played(run, 6), "Ego"));
    assertEquals(Math.PI / 2, state(run, "Ego").pose().heading(), EXACT);
    assertEquals(10, state(run, "Ego").vy(), EXACT);
    played(run, 9);
    assertTrue(changes(run).contains("8.00 S/A/G/M/E END COMPLETE"));
    // It goes straight on where its lane is not ahead of it.
    assertAt(30, 50, state(run, "Ego"));
    StoryboardRun later = ego(follow(CORNER, NONE, "initialDistanceOffset='30'"));
    assertAt(30, 10, state(played(later, 2), "Ego"));
  }

  @Test
  void beginsAgainWhereItIsClosed() {
    StoryboardRun run = ego(follow(CORNER, NONE, "data-closed=''"));
    // 30 m, 40 m and 50 m back
    assertAt(15, 20, state(played(run, 1 + 9.5), "Ego"));
    assertAt(5, 0, state(played(run, 1 + 12.5), "Ego"));
    assertTrue(changes(run).stream().noneMatch(each -> each.contains("E END")));
  }

  @Test
  void isWhereTheTimesSay() {
    StoryboardRun run = ego(follow(TIMED, timing("relative", 0, 1), ""));
    assertAt(15, 0, state(played(run, 2), "Ego"));
    assertEquals(15, state(run, "Ego").speed(), EXACT);
    assertAt(30, 10, state(played(run, 4), "Ego"));
    assertEquals(10, state(run, "Ego").speed(), EXACT);
    played(run, 8);
    assertTrue(changes(run).contains("7.00 S/A/G/M/E END COMPLETE"));
    StoryboardRun scaled = ego(follow(TIMED, timing("relative", 1, 2), ""));
    assertAt(0, 0, state(played(scaled, 2), "Ego"));
    assertEquals(0, state(played(scaled, 1.5), "Ego").speed() * 0, EXACT);
    assertAt(15, 0, state(played(scaled, 4), "Ego"));
    assertEquals(7.5, state(scaled, "Ego").speed(), EXACT);
    StoryboardRun absolute = ego(follow(TIMED, timing("absolute", 0, 1), ""));
    assertAt(15, 0, state(played(absolute, 1), "Ego"));
    assertAt(30, 10, state(played(absolute, 3), "Ego"));
  }

  /** A quarter of a circle with a radius of 20 m. */
  @Test
  void followsCurves() {
    String start = "<Position><WorldPosition x='0' y='0' h='0'/></Position>";
    double quarter = 10 * Math.PI;
    String arc =
        "<Clothoid curvature='0.05' curvaturePrime='0' length='"
            + quarter
            + "'>"
            + start
            + "</Clothoid>";
    StoryboardRun run = played(ego(follow(arc, NONE, "")), 3);
    assertAt(20 * Math.sin(1), 20 - 20 * Math.cos(1), state(run, "Ego"));
    assertEquals(1, state(run, "Ego").pose().heading(), EXACT);
    assertEquals(0.05, state(run, "Ego").curvature(), EXACT);
    String spline =
        "<ClothoidSpline><ClothoidSplineSegment curvatureStart='0' curvatureEnd='0' length='10'>"
            + start.replace("Position>", "PositionStart>").replace("<WorldPositionStart>", "")
            + "</ClothoidSplineSegment><ClothoidSplineSegment curvatureStart='0.05'"
            + " curvatureEnd='0.05' length='20'/></ClothoidSpline>";
    StoryboardRun both = played(ego(follow(spline, NONE, "")), 3);
    assertAt(10 + 20 * Math.sin(0.5), 20 - 20 * Math.cos(0.5), state(both, "Ego"));
    String nurbs =
        "<Nurbs order='3'>"
            + control(20, 0, 1)
            + control(20, 20, Math.sqrt(0.5))
            + control(0, 20, 1)
            + "<Knot value='0'/><Knot value='0'/><Knot value='0'/><Knot value='1'/>"
            + "<Knot value='1'/><Knot value='1'/></Nurbs>";
    StoryboardRun blended = played(ego(follow(nurbs, NONE, "")), 3);
    assertEquals(20 * Math.cos(1), state(blended, "Ego").pose().x(), 1e-3);
    assertEquals(20 * Math.sin(1), state(blended, "Ego").pose().y(), 1e-3);
    assertTrue(
        changes(played(blended, 5)).stream().anyMatch(each -> each.matches("4.15 .*E END.*")));
  }

  /** The end of a clothoid with a curvature of a s, by the series of Fresnel's integrals. */
  @Test
  void followsASpiral() {
    String spiral =
        "<Clothoid curvature='0' curvaturePrime='0.002' length='40'><Position><WorldPosition x='0'"
            + " y='0'/></Position></Clothoid>";
    StoryboardRun run = played(ego(follow(spiral, NONE, "")), 4);
    double s = 30;
    double half = 0.001;
    double x = 0;
    double y = 0;
    double factorial = 1;
    for (int n = 0; n < 12; n++) {
      double term = Math.pow(half, n) * Math.pow(s, 2 * n + 1) / (2 * n + 1) / factorial;
      double sign = n % 4 < 2 ? 1 : -1;
      x += n % 2 == 0 ? sign * term : 0;
      y += n % 2 == 1 ? sign * term : 0;
      factorial *= n + 1;
    }
    assertAt(x, y, state(run, "Ego"));
  }

  private static String control(double x, double y, double weight) {
    return "<ControlPoint weight='"
        + weight
        + "'><Position><WorldPosition x='"
        + x
        + "' y='"
        + y
        + "'/></Position></ControlPoint>";
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<Polyline><Vertex><Position><WorldPosition x='0' y='0'/></Position></Vertex></Polyline>"
            + " | The trajectory has 1 vertex, and needs two.",
        "<Polyline><Vertex time='2'><Position><WorldPosition x='0' y='0'/></Position></Vertex>"
            + "<Vertex time='1'><Position><WorldPosition x='9' y='0'/></Position></Vertex>"
            + "</Polyline> | The time of a trajectory goes back from 2.0 s to 1.0 s.",
        "<Polyline><Vertex><Position><WorldPosition x='0' y='0'/></Position></Vertex><Vertex>"
            + "<Position><WorldPosition x='0' y='0'/></Position></Vertex></Polyline>"
            + " | The trajectory has no length.",
        "<ClothoidSpline><ClothoidSplineSegment curvatureStart='0' curvatureEnd='0' length='1'/>"
            + "</ClothoidSpline> | The first segment of the trajectory has no start.",
        "<Clothoid curvature='0' length='10' startTime='5' stopTime='4'><Position>"
            + "<WorldPosition x='0' y='0'/></Position></Clothoid>"
            + " | The trajectory ends before it begins.",
        "<Nurbs order='2'/> | A NURBS of order 2 needs at least as many control points, and as"
            + " many knots as both together: it has 0 and 0.",
      })
  void refusesWhatIsNoTrajectory(String shape, String message) {
    Diagnostic finding =
        assertThrows(DiagnosticException.class, () -> ego(follow(shape, NONE, "")))
            .diagnostics()
            .get(0);
    assertEquals("storyboard.trajectory", finding.id());
    assertEquals(message, finding.message());
  }

  private static StoryboardRun pedestrian(String action) {
    String walker =
        "<ScenarioObject name='Ego'><Pedestrian name='p' mass='80' pedestrianCategory='pedestrian'>"
            + "<BoundingBox><Center x='0' y='0' z='0.9'/><Dimensions length='0.5' width='0.5'"
            + " height='1.8'/></BoundingBox></Pedestrian></ScenarioObject>";
    String init =
        privately(
            "Ego",
            teleport("<WorldPosition x='50' y='-10' h='1.5707963267948966'/>"),
            speed("step", "time", 0, 2));
    return run(scenario(walker, init, story("Ego", event("E", action, after(1)))));
  }

  @Test
  void walksStraightFromWaypointToWaypoint() {
    String route =
        "<PrivateAction><RoutingAction><AssignRouteAction><Route name='r' closed='false'>"
            + waypoint(50, -8)
            + waypoint(50, -2)
            + waypoint(60, -2)
            + "</Route></AssignRouteAction></RoutingAction></PrivateAction>";
    StoryboardRun run = pedestrian(route);
    assertAt(50, -8, state(played(run, 1), "Ego"));
    assertAt(50, -2, state(played(run, 4), "Ego"));
    assertAt(54, -2, state(played(run, 6), "Ego"));
    assertTrue(changes(run).contains("1.00 S/A/G/M/E END COMPLETE"));
  }

  private static String waypoint(double x, double y) {
    return "<Waypoint routeStrategy='shortest'><Position><WorldPosition x='"
        + x
        + "' y='"
        + y
        + "'/></Position></Waypoint>";
  }

  @Test
  void acquiresAPosition() {
    String acquire =
        "<PrivateAction><RoutingAction><AcquirePositionAction><Position>%s</Position>"
            + "</AcquirePositionAction></RoutingAction></PrivateAction>";
    StoryboardRun walker = pedestrian(acquire.formatted("<WorldPosition x='54' y='-5'/>"));
    played(walker, 4);
    assertTrue(changes(walker).contains("3.50 S/A/G/M/E END COMPLETE"));
    StoryboardRun driver =
        played(ego(acquire.formatted("<LanePosition roadId='1' laneId='-1' s='140'/>")), 5);
    assertAt(150, -1.75, state(driver, "Ego"));
    assertTrue(changes(driver).stream().anyMatch(each -> each.matches("4.0[01] S/A/G/M/E END.*")));
  }
}

package dev.eventchain.openscenario.storyboard;

import static dev.eventchain.openscenario.storyboard.Scenarios.car;
import static dev.eventchain.openscenario.storyboard.Scenarios.privately;
import static dev.eventchain.openscenario.storyboard.Scenarios.run;
import static dev.eventchain.openscenario.storyboard.Scenarios.scenario;
import static dev.eventchain.openscenario.storyboard.Scenarios.state;
import static dev.eventchain.openscenario.storyboard.Scenarios.teleport;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.openscenario.storyboard.network.NetworkRoads;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import dev.eventchain.roads.RoadNetwork;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/**
 * Tests roads of OpenDRIVE as a storyboard sees them: a straight one of 100 m along the x axis, and
 * one with a radius of 100 m to the left that follows it, with a lane in each direction.
 */
class NetworkRoadsTest {

  private static final RoadMap ROADS = roads("");

  private static RoadMap roads(String inHeader) {
    String text =
        "<OpenDRIVE><header revMajor='1' revMinor='7'>"
            + inHeader
            + "</header>"
            + road("1", 100, "x='0' y='0'", "<line/>", "successor", "2", "start")
            + road("2", 50, "x='100' y='0'", "<arc curvature='0.01'/>", "predecessor", "1", "end")
            + "</OpenDRIVE>";
    return new NetworkRoads(RoadNetwork.parse(SourceText.of("test.xodr", text)));
  }

  private static String road(
      String id,
      double length,
      String at,
      String shape,
      String link,
      String other,
      String contact) {
    String lanes =
        "<lane id='%d' type='driving' level='false'><link><%s id='%d'/></link>"
            + "<width sOffset='0' a='3.5' b='0' c='0' d='0'/></lane>";
    return "<road name='' length='"
        + length
        + "' id='"
        + id
        + "' junction='-1'><link><"
        + link
        + " elementType='road' elementId='"
        + other
        + "' contactPoint='"
        + contact
        + "'/></link><planView><geometry s='0' "
        + at
        + " hdg='0' length='"
        + length
        + "'>"
        + shape
        + "</geometry></planView><lanes><laneSection s='0'><left>"
        + String.format(lanes, 1, link, 1)
        + "</left><center><lane id='0' type='none' level='false'/></center><right>"
        + String.format(lanes, -1, link, -1)
        + "</right></laneSection></lanes></road>";
  }

  @Test
  void knowsItsRoadsAndLanes() {
    assertTrue(ROADS.hasRoad("2"));
    assertFalse(ROADS.hasRoad("3"));
    assertEquals(50, ROADS.length("2"));
    assertEquals(List.of(1, -1), ROADS.lanes("1", 10));
    assertEquals(-1.75, ROADS.centre("1", 10, -1), 1e-9);
    assertTrue(ROADS.goesAlongS("1", 10, -1));
    assertFalse(ROADS.goesAlongS("1", 10, 1));
    Pose bent = ROADS.pose(new RoadPoint("2", 50, 0));
    assertEquals(100 + 100 * Math.sin(0.5), bent.x(), 1e-6);
    assertEquals(0.5, bent.heading(), 1e-9);
    assertEquals(
        new LanePoint("1", -1, 20, 0.25), ROADS.find(Pose.flat(20, -1.5, 0)).orElseThrow());
    assertTrue(ROADS.find(Pose.flat(20, -9, 0)).isEmpty());
  }

  /** In the right lane, the bend has a radius of 101.75 m. */
  @Test
  void leadsFromRoadToRoad() {
    Optional<RoadMap.Moved> at =
        Optional.of(new RoadMap.Moved(new LanePoint("1", -1, 90, 0), true));
    for (int i = 0; i < 200; i++) {
      at = ROADS.move(at.orElseThrow().point(), true, 0.1, List.of());
    }
    LanePoint there = at.orElseThrow().point();
    assertEquals("2", there.road());
    assertEquals(-1, there.lane());
    assertEquals(10 / 1.0175, there.s(), 2e-3);
    assertTrue(ROADS.move(there, true, 60, List.of()).isEmpty());
    Optional<RoadMap.Moved> back =
        ROADS.move(new LanePoint("2", 1, 0.05, 0), false, 0.1, List.of(new RoadPoint("1", 5, 0)));
    assertEquals("1", back.orElseThrow().point().road());
    assertEquals(99.95, back.orElseThrow().point().s(), 1e-2);
    assertFalse(back.orElseThrow().alongS());
  }

  @Test
  void measuresAlongTheRoads() {
    RoadPoint first = new RoadPoint("1", 80, -1);
    RoadPoint second = new RoadPoint("2", 10, -1);
    assertEquals(30, ROADS.along(first, second).orElseThrow(), 1e-9);
    assertEquals(-30, ROADS.along(second, first).orElseThrow(), 1e-9);
    RoadPoint oncoming = new RoadPoint("2", 10, 1);
    assertEquals(30, ROADS.along(new RoadPoint("1", 80, 1), oncoming).orElseThrow(), 1e-9);
  }

  @Test
  void leadsOverWaypoints() {
    List<LanePoint> there = List.of(new LanePoint("1", -1, 80, 0), new LanePoint("2", -1, 10, 0));
    assertEquals(
        List.of(new RoadMap.Stretch("1", true, 80, 100), new RoadMap.Stretch("2", true, 0, 10)),
        ROADS.way(there));
    List<LanePoint> back = List.of(new LanePoint("2", 1, 10, 0), new LanePoint("1", 1, 80, 0));
    assertEquals(
        List.of(new RoadMap.Stretch("2", false, 10, 0), new RoadMap.Stretch("1", false, 100, 80)),
        ROADS.way(back));
    assertEquals(List.of(), ROADS.way(List.of(there.get(1), there.get(0))));
    assertEquals("there is none", ROADS.geoProblem().orElseThrow());
  }

  /** One second of latitude is 30.9 m there, one of longitude 20.7 m. */
  @Test
  void hasPlacesOnTheEarth() {
    String reference = "<geoReference><![CDATA[+proj=%s +lat_0=48 +lon_0=11]]></geoReference>";
    RoadMap roads = roads(reference.formatted("tmerc"));
    String second = "<GeoPosition latitudeDeg='48' longitudeDeg='11.000277777778'/>";
    Pose place = state(placed(second, roads), "Ego").pose();
    assertEquals(20.7, place.x(), 0.05);
    assertEquals(0, place.y(), 1e-3);
    String radians = "<GeoPosition latitude='0.837758040957' longitude='0.191986217719'/>";
    assertEquals(0, state(placed(radians, roads), "Ego").pose().x(), 1e-3);
    assertEquals(
        "There is no latitude of 2750.1974166279515 degrees.",
        assertThrows(
                DiagnosticException.class,
                () -> placed("<GeoPosition latitude='48' longitude='11'/>", roads))
            .diagnostics()
            .get(0)
            .message());
    Diagnostic finding =
        assertThrows(
                DiagnosticException.class, () -> placed(second, roads(reference.formatted("merc"))))
            .diagnostics()
            .get(0);
    assertEquals("storyboard.place.none", finding.id());
    assertEquals(
        "A GeoPosition needs the geoReference of the road network: the projection `merc` is not"
            + " known, only `tmerc` and `utm` are.",
        finding.message());
  }

  private static StoryboardRun placed(String position, RoadMap roads) {
    return run(
        scenario(car("Ego"), privately("Ego", teleport(position)), ""), roads, Optional.empty());
  }
}

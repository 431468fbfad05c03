package dev.eventchain.roads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.roads.road.Header;
import dev.eventchain.roads.road.Lane;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.RoadMark;
import dev.eventchain.roads.road.RoadObject;
import dev.eventchain.roads.road.Signal;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

class RoadTest {

  private static final RoadNetwork NETWORK = Networks.read("tilted");
  private static final Road BANKED = NETWORK.road("1").orElseThrow();

  private static void assertPose(Pose expected, Pose actual) {
    assertEquals(expected.x(), actual.x(), 1e-9, "x");
    assertEquals(expected.y(), actual.y(), 1e-9, "y");
    assertEquals(expected.z(), actual.z(), 1e-9, "z");
    assertEquals(expected.heading(), actual.heading(), 1e-9, "heading");
    assertEquals(expected.pitch(), actual.pitch(), 1e-9, "pitch");
    assertEquals(expected.roll(), actual.roll(), 1e-9, "roll");
  }

  @Test
  void headerIsRead() {
    assertEquals(
        new Header(
            8,
            "tilted",
            "",
            "+proj=utm +zone=32 +datum=WGS84",
            new Header.Offset(1000, 2000, 3, 0.5)),
        NETWORK.header());
  }

  @Test
  void userDataOfRoadsIsHandedOn() {
    assertEquals(Optional.of("abc"), BANKED.userData("tool.note"));
    assertEquals(Optional.empty(), BANKED.userData("tool.tree"));
    assertEquals(Optional.empty(), BANKED.userData("tool.other"));
  }

  @Test
  void superelevationRaisesTheLeft() {
    double cos = Math.cos(0.1);
    double sin = Math.sin(0.1);
    assertPose(new Pose(20, 20 + 2 * cos, 5 + 2 * sin, 0, 0, 0.1), BANKED.pose(10, 2));
    assertPose(new Pose(20, 20 - 2 * cos, 5 - 2 * sin, 0, 0, 0.1), BANKED.pose(10, -2));
    assertPose(
        new Pose(20, 20 + 2 * cos - sin, 5 + 2 * sin + cos, 0, 0, 0.1), BANKED.pose(10, 2, 1));
  }

  @Test
  void slopesTurnTheNoseUp() {
    Pose pose = BANKED.pose(90, 0);
    assertEquals(5 + 0.0005 * 50 * 50, pose.z(), 1e-9);
    assertEquals(-Math.atan(0.05), pose.pitch(), 1e-9);
  }

  /** The sidewalk begins at t = 3.1 and is level, with a kerb of 12 cm that rises by 3 cm. */
  @Test
  void levelLanesAreNotTiltedAndHaveTheirHeight() {
    Pose pose = BANKED.pose(10, 4.1);
    assertEquals(5 + 3.1 * Math.sin(0.1) + 0.135, pose.z(), 1e-9);
    assertEquals(20 + 3.1 * Math.cos(0.1) + 1, pose.y(), 1e-9);
    assertEquals(0, pose.roll());
  }

  @Test
  void crossfallFallsToBothSidesAndShapesAreInterpolated() {
    Road road = NETWORK.road("2").orElseThrow();
    assertEquals(-2 * Math.sin(0.02), road.pose(10, -2).z(), 1e-9);
    double shape = 0.05 * 2 * (1 - 10.0 / 50);
    assertEquals(-2 * Math.sin(0.02) + shape * Math.cos(0.02), road.pose(10, 2).z(), 1e-9);
    assertEquals(-0.02, road.pose(10, 2).roll(), 1e-9);
    assertEquals(-0.01, road.curvature(3));
  }

  @Test
  void bordersAreMeasuredFromLaneZeroAndWidthsFromTheInnerEdge() {
    LaneSection section = BANKED.section(30);
    assertEquals(0.1, section.outerEdge(0, 30), 1e-12);
    assertEquals(3.3 + 0.1, section.outerEdge(1, 30), 1e-12);
    assertEquals(3.3, section.width(1, 30), 1e-12);
    assertEquals(5.4, section.leftEdge(30), 1e-12);
    assertEquals(-2.9, section.outerEdge(-1, 30), 1e-12);
    assertEquals(-3.9, section.rightEdge(30), 1e-12);
    assertEquals(-1.4, section.centre(-1, 30), 1e-12);
    assertEquals(OptionalInt.of(-2), BANKED.laneAt(30, -3));
    assertEquals(OptionalInt.of(1), BANKED.laneAt(30, 0.1));
    assertEquals(OptionalInt.of(2), BANKED.laneAt(30, 5.4));
    assertEquals(OptionalInt.empty(), BANKED.laneAt(30, 5.41));
    assertThrows(IllegalArgumentException.class, () -> section.width(3, 30));
  }

  /** At 60, a section begins that is about the left only. */
  @Test
  void sectionsOfOneSideLeaveTheOtherAsItIs() {
    assertEquals(2, BANKED.sections().size());
    assertEquals(List.of(2, 1, -1, -2), BANKED.laneIds(70));
    assertEquals(3.6, BANKED.section(70).width(1, 70), 1e-12);
    assertEquals(3, BANKED.section(70).width(-1, 70), 1e-12);
    LanePath path = NETWORK.path(new LanePosition("1", -1, 10, 0), true, 0, 80).orElseThrow();
    assertEquals(100, path.length(), 0.01);
  }

  @Test
  void speedLimitsAreThoseOfTheLaneOrElseOfTheRoad() {
    assertEquals(OptionalDouble.of(10), BANKED.speedLimit(10));
    assertEquals(OptionalDouble.of(10), BANKED.speedLimit(10, 1));
    assertEquals(OptionalDouble.of(20 * 0.44704), BANKED.speedLimit(40, 1));
    assertEquals(OptionalDouble.empty(), BANKED.speedLimit(60));
    assertEquals("motorway", BANKED.type(60).orElseThrow().type());
  }

  @Test
  void onLeftHandRoadsTheLeftLanesLeadAlongS() {
    Lane left = BANKED.lane(0, 1).orElseThrow();
    assertTrue(BANKED.leads(left, true));
    assertFalse(BANKED.leads(left, false));
    assertTrue(left.isDrivable());
    assertFalse(BANKED.lane(0, 2).orElseThrow().isDrivable());
  }

  @Test
  void marksAreRead() {
    assertEquals(
        List.of(
            new RoadMark(0, "solid", "white", "standard", 0.12, "none", List.of()),
            new RoadMark(
                10,
                "broken",
                "yellow",
                "bold",
                0,
                "both",
                List.of(new RoadMark.Line(3, 6, 0, 0, 0.15)))),
        BANKED.lane(0, 1).orElseThrow().marks());
  }

  private static RoadObject object(String id) {
    return BANKED.objects().stream().filter(each -> each.id().equals(id)).findFirst().orElseThrow();
  }

  @Test
  void objectsStandWhereTheyAreRepeated() {
    assertEquals(Optional.of(0.1), object("pole").bodies().get(0).radius());
    List<RoadObject.Body> posts = object("posts").bodies();
    assertEquals(4, posts.size());
    assertEquals(List.of(1.0, 2.0, 3.0, 4.0), posts.stream().map(RoadObject.Body::height).toList());
    assertEquals(40, posts.get(3).pose().x(), 1e-9);
    List<RoadObject.Body> rail = object("rail").bodies();
    assertEquals(List.of(4.0, 4.0, 4.0), rail.stream().map(RoadObject.Body::length).toList());
    assertEquals(12, rail.get(0).pose().x(), 1e-9);
    assertEquals(0.3, rail.get(0).width());
    RoadObject.Outline outline = object("block").bodies().get(0).outlines().get(0);
    Pose origin = BANKED.pose(10, 10);
    assertTrue(outline.closed());
    assertEquals(origin.y() + 1, outline.corners().get(0).y(), 1e-9);
    assertEquals(origin.x() - 1, outline.corners().get(1).x(), 1e-9);
    assertEquals(
        new RoadObject.Corner(origin.x(), origin.y(), origin.z(), 3), outline.corners().get(2));
  }

  @Test
  void outlinesByTheRoadMoveWithTheirRepetitions() {
    List<RoadObject.Body> strips = object("strip").bodies();
    assertEquals(3, strips.size());
    RoadObject.Outline outline = strips.get(1).outlines().get(0);
    Pose corner = BANKED.pose(22, -6);
    assertFalse(outline.closed());
    assertEquals(
        new RoadObject.Corner(corner.x(), corner.y(), corner.z(), 1), outline.corners().get(1));
  }

  @Test
  void signalsFaceTheirTrafficAndReferToEachOther() {
    Signal limit = BANKED.signals().get(0);
    assertEquals(Math.PI, limit.pose().heading(), 1e-9);
    assertEquals(OptionalDouble.of(60), limit.value());
    assertEquals(Optional.of(List.of(1)), limit.lanes());
    Signal light = BANKED.signals().get(1);
    assertTrue(light.dynamic());
    assertEquals(new Pose(1, 2, 3, 0.5, 0, 0), light.pose());
    assertEquals("light", NETWORK.road("2").orElseThrow().signalReferences().get(0).signal());
    assertEquals(
        List.of(new Signal.Controller("c", "lights", List.of("light"))), NETWORK.controllers());
  }

  @Test
  void placesBesideAllRoadsAreLocatedByTheNearest() {
    RoadNetwork crossing = Networks.read("crossing");
    Pose beside = crossing.road("0").orElseThrow().pose(20, 9);
    assertEquals(Optional.empty(), crossing.locate(beside.x(), beside.y()));
    RoadPosition nearest = crossing.nearest(beside.x(), beside.y());
    assertEquals("0", nearest.road());
    assertEquals(20, nearest.s(), 1e-6);
    assertEquals(9, nearest.t(), 1e-6);
    assertEquals(OptionalInt.empty(), nearest.lane());
  }

  /** Three roads through the junction are there; the position before decides. */
  @Test
  void onAJunctionTheRoadStaysThatOfThePositionBefore() {
    RoadNetwork crossing = Networks.read("crossing");
    for (String id : List.of("200", "201", "203")) {
      Pose pose = crossing.road(id).orElseThrow().pose(1, -1);
      RoadPosition near = new RoadPosition(id, 0, 0, OptionalInt.of(-1));
      assertEquals(id, crossing.locate(pose.x(), pose.y(), near).orElseThrow().road());
    }
  }
}

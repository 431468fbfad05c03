package dev.eventchain.simulation.export;

import dev.eventchain.simulation.sensor.RoadScene;
import dev.eventchain.simulation.stage.FurnishedRoad;
import dev.eventchain.simulation.world.Road;

/** The OpenDRIVE file of a road: a line or an arc, lanes, walls and posts. */
final class RoadFile {

  /** Width of a wall, which the scenario does not say, in m. */
  private static final double WALL_WIDTH = 0.2;

  private static final double MARK_WIDTH = 0.12;

  /** Width from which on a shoulder is one, in m. */
  private static final double NARROWEST = 0.1;

  private final RoadFrame frame;
  private final int left;
  private final int right;

  /**
   * Creates a file.
   *
   * @param left how many lanes there are to the left of the ego's
   * @param right how many there are to the right of it
   */
  RoadFile(RoadFrame frame, int left, int right) {
    this.frame = frame;
    this.left = left;
    this.right = right;
  }

  Markup markup(String name) {
    Markup header =
        new Markup("header")
            .with("revMajor", "1")
            .with("revMinor", "7")
            .with("name", name)
            .with("version", "1")
            .with("date", OpenScenarioFile.DATE)
            .with("vendor", "Eventchain");
    Markup road =
        new Markup("road")
            .with("id", RoadFrame.ROAD)
            .with("junction", "-1")
            .with("length", frame.length())
            .with("name", name)
            .with("rule", "RHT");
    road.add(planView(), new Markup("lanes").add(lanes()));
    if (frame.road().isFurnished()) {
      road.add(objects());
      road.add(new Markup("userData").with("code", FurnishedRoad.CODE).with("value", "true"));
    }
    return new Markup("OpenDRIVE").add(header, road);
  }

  private Markup planView() {
    Road.Place start = frame.start();
    Markup geometry =
        new Markup("geometry")
            .with("s", 0.0)
            .with("x", start.x())
            .with("y", start.y())
            .with("hdg", start.heading())
            .with("length", frame.length());
    Markup line =
        frame.road().isStraight()
            ? new Markup("line")
            : new Markup("arc")
                .with("curvature", Double.toString(frame.curvature() / frame.scale()));
    return new Markup("planView").add(geometry.add(line));
  }

  private Markup lanes() {
    Markup section = new Markup("laneSection").with("s", 0.0);
    double width = frame.laneWidth();
    double leftShoulder = Road.WALL_DISTANCE - width / 2 - left * width;
    double rightShoulder = Road.WALL_DISTANCE - width / 2 - right * width;
    Markup toTheLeft = new Markup("left");
    if (leftShoulder >= NARROWEST) {
      toTheLeft.add(lane(left + 1, "shoulder", leftShoulder, "none"));
    }
    for (int id = left; id > 0; id--) {
      toTheLeft.add(lane(id, "driving", width, id == left ? "solid" : "broken"));
    }
    Markup middle = new Markup("lane").with("id", "0").with("type", "none").with("level", "false");
    section.add(toTheLeft);
    section.add(new Markup("center").add(middle.add(mark(left == 0 ? "solid" : "broken"))));
    Markup toTheRight = new Markup("right");
    for (int id = 1; id <= right + 1; id++) {
      toTheRight.add(lane(-id, "driving", width, id == right + 1 ? "solid" : "broken"));
    }
    if (rightShoulder >= NARROWEST) {
      toTheRight.add(lane(-right - 2, "shoulder", rightShoulder, "none"));
    }
    return section.add(toTheRight);
  }

  private static Markup lane(int id, String type, double width, String mark) {
    return new Markup("lane")
        .with("id", Integer.toString(id))
        .with("type", type)
        .with("level", "false")
        .add(
            new Markup("width")
                .with("sOffset", 0.0)
                .with("a", width)
                .with("b", 0.0)
                .with("c", 0.0)
                .with("d", 0.0),
            mark(mark));
  }

  private static Markup mark(String type) {
    return new Markup("roadMark")
        .with("sOffset", 0.0)
        .with("type", type)
        .with("weight", "standard")
        .with("color", "standard")
        .with("width", type.equals("none") ? 0.0 : MARK_WIDTH);
  }

  private Markup objects() {
    double wall = Road.WALL_DISTANCE + WALL_WIDTH / 2;
    double first = -Math.floor(frame.behind() / RoadScene.POST_SPACING) * RoadScene.POST_SPACING;
    double middle = first + RoadScene.POST_WIDTH / 2;
    double last = Math.floor((frame.ahead() - middle) / RoadScene.POST_SPACING);
    double row = last * RoadScene.POST_SPACING * frame.scale();
    return new Markup("objects")
        .add(
            wall("left wall", frame.t(wall)),
            wall("right wall", frame.t(-wall)),
            posts("left post", frame.t(RoadScene.POST_DISTANCE), frame.s(middle), row),
            posts("right post", frame.t(-RoadScene.POST_DISTANCE), frame.s(middle), row));
  }

  private Markup wall(String name, double t) {
    Markup wall = object(name, "barrier", 0.0, t, frame.length(), WALL_WIDTH);
    Markup repeat = repeat(0.0, frame.length(), 0.0, t, RoadScene.WALL_HEIGHT);
    repeat.with("widthStart", WALL_WIDTH).with("widthEnd", WALL_WIDTH);
    return wall.with("height", RoadScene.WALL_HEIGHT).add(repeat);
  }

  private Markup posts(String name, double t, double s, double row) {
    double width = RoadScene.POST_WIDTH;
    double spacing = RoadScene.POST_SPACING * frame.scale();
    Markup repeat = repeat(s, row, spacing, t, RoadScene.POST_HEIGHT);
    repeat.with("lengthStart", width).with("lengthEnd", width);
    repeat.with("widthStart", width).with("widthEnd", width);
    return object(name, "pole", s, t, width, width)
        .with("height", RoadScene.POST_HEIGHT)
        .add(repeat);
  }

  private static Markup object(
      String name, String type, double s, double t, double length, double width) {
    return new Markup("object")
        .with("id", name.replace(' ', '-'))
        .with("name", name)
        .with("type", type)
        .with("s", s)
        .with("t", t)
        .with("zOffset", 0.0)
        .with("hdg", 0.0)
        .with("orientation", "none")
        .with("length", length)
        .with("width", width);
  }

  private static Markup repeat(double s, double length, double spacing, double t, double height) {
    return new Markup("repeat")
        .with("s", s)
        .with("length", length)
        .with("distance", spacing)
        .with("tStart", t)
        .with("tEnd", t)
        .with("heightStart", height)
        .with("heightEnd", height)
        .with("zOffsetStart", 0.0)
        .with("zOffsetEnd", 0.0);
  }
}

package dev.eventchain.simulation.export;

import dev.eventchain.simulation.world.Road;

/**
 * The road of a scenario as a road of OpenDRIVE: its reference line is the left line of the ego's
 * lane, which is lane -1, and begins far enough behind all that moves. The map is that of the
 * scenario: at the start, the ego's front bumper is at its origin and the road goes along the x
 * axis.
 *
 * @param behind how far the road reaches behind the origin, in m along the ego's lane
 * @param ahead how far it reaches ahead likewise
 */
record RoadFrame(Road road, double behind, double ahead) {

  /** The only road. */
  static final String ROAD = "1";

  /** The ego's lane. */
  static final String LANE = "-1";

  double laneWidth() {
    return road.laneWidth(0.0);
  }

  double curvature() {
    return road.curvature(0.0);
  }

  /** Returns the length of the reference line for each metre of the ego's lane. */
  double scale() {
    return 1.0 - curvature() * laneWidth() / 2;
  }

  double length() {
    return (behind + ahead) * scale();
  }

  /** Returns the s coordinate of a place along the ego's lane. */
  double s(double along) {
    return (along + behind) * scale();
  }

  /** Returns the t coordinate of a place across the road. */
  double t(double across) {
    return across - laneWidth() / 2;
  }

  /** Returns the start of the reference line. */
  Road.Place start() {
    return road.place(-behind, laneWidth() / 2);
  }

  /** Returns how fast something drives that has a speed along the ego's lane, for 1 m/s of it. */
  double pace(double across) {
    return 1.0 - curvature() * across;
  }

  /** Returns a place in the ego's lane, or beside it, whose s coordinate is given as text. */
  static Markup lanePosition(String s, double offset, double heading) {
    Markup position =
        new Markup("LanePosition")
            .with("roadId", ROAD)
            .with("laneId", LANE)
            .with("s", s)
            .with("offset", offset);
    return new Markup("Position")
        .add(position.add(new Markup("Orientation").with("type", "relative").with("h", heading)));
  }

  static Markup worldPosition(Road.Place place) {
    return new Markup("Position")
        .add(
            new Markup("WorldPosition")
                .with("x", place.x())
                .with("y", place.y())
                .with("h", place.heading()));
  }
}

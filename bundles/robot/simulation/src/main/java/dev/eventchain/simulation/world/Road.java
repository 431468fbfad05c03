package dev.eventchain.simulation.world;

import java.util.List;

/**
 * The road as the ego's lane has it: its centre line is that of the lane in which the ego starts,
 * begins at the ego's front bumper, and goes along the x axis there.
 */
public interface Road {

  /** The usual width of a lane of a motorway (German RAA 2008, cross-section RQ 31: 3.75 m). */
  double USUAL_LANE_WIDTH = 3.75;

  /** Distance from the centre line to the walls on both sides of a furnished road, in m. */
  double WALL_DISTANCE = 8.0;

  /** A place and a direction in the plane, in m and rad; at the start x is along the road. */
  record Place(double x, double y, double heading) {

    /** Returns the place ahead of this one by a distance in m. */
    public Place ahead(double distance) {
      return new Place(
          x + distance * StrictMath.cos(heading), y + distance * StrictMath.sin(heading), heading);
    }
  }

  /** A place in road coordinates: along its centre line, and left of it, in m. */
  record Station(double along, double across) {}

  /**
   * Returns a furnished road of constant curvature.
   *
   * @param curvature in 1/m, to the left is positive, 0 if it is straight
   * @param laneWidth between the lines of each lane, in m
   */
  static Road bend(double curvature, double laneWidth) {
    return new Bend(curvature, laneWidth);
  }

  /** Returns a straight furnished road. */
  static Road straight() {
    return bend(0.0, USUAL_LANE_WIDTH);
  }

  /**
   * A line on the ground, such as the border of a lane.
   *
   * @param broken whether it has dashes
   * @param places from one end to the other
   */
  record Line(boolean broken, List<Place> places) {}

  /**
   * Returns the lines near a part of a road that is not furnished, whose lines follow from its
   * lanes alone.
   *
   * @param from the begin of the part along the road, in m
   * @param to its end
   */
  default List<Line> lines(double from, double to) {
    return List.of();
  }

  /** Returns whether it is straight from end to end. */
  boolean isStraight();

  /** Returns whether a wall and posts stand on both sides. */
  boolean isFurnished();

  /** Returns the place of a station, in the direction of the road. */
  Place place(double along, double across);

  /**
   * Returns the station of a place.
   *
   * @param near approximate distance along the road, since a road may return to its start
   */
  Station station(double x, double y, double near);

  /** Returns the direction of the road at a distance along it, in rad. */
  double heading(double along);

  /** Returns its curvature at a distance along it, in 1/m, to the left is positive. */
  double curvature(double along);

  /** Returns the distance between the lines of the ego's lane, in m. */
  double laneWidth(double along);

  /**
   * Returns the distance to the left line of the ego's lane from a station left of its centre line,
   * in m.
   */
  default double toTheLeft(Station station) {
    return laneWidth(station.along()) / 2 - station.across();
  }

  /** Returns the distance to the right line likewise. */
  default double toTheRight(Station station) {
    return laneWidth(station.along()) / 2 + station.across();
  }

  /**
   * Returns the distance at which a ray meets the nearest wall, in m; infinite if it never does.
   *
   * @param from a place between the walls
   * @param dx direction of the ray in the plane, with the length of its projection
   */
  double wall(Place from, double dx, double dy);
}

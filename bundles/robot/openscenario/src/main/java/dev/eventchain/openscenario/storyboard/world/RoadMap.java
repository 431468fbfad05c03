package dev.eventchain.openscenario.storyboard.world;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** The roads, as far as a storyboard asks for them. Calls do not change it. */
public interface RoadMap {

  /** A place on the way along lanes, and whether it is passed in the direction of its s. */
  record Moved(LanePoint point, boolean alongS) {}

  /** Returns whether there is a road. */
  boolean hasRoad(String road);

  /** Returns the length of a road that is there. */
  double length(String road);

  /** Returns the numbers of the lanes at a place of a road, from left to right, without 0. */
  List<Integer> lanes(String road, double s);

  /** Returns the t of the centre of a lane that is there. */
  double centre(String road, double s, int lane);

  /** Returns whether traffic on a lane goes in the direction of s. */
  boolean goesAlongS(String road, double s, int lane);

  /** Returns the pose of a point: its heading is the direction of s there. */
  Pose pose(RoadPoint point);

  /** Returns the point of a road below a place; empty off the roads. */
  Optional<LanePoint> find(Pose place);

  /**
   * Returns the place after a way along a lane and those that follow it.
   *
   * @param alongS whether the way goes in the direction of s
   * @param distance the length of the way at the point's offset; negative backward
   * @param route the roads to take where a choice is, in their order; may be empty
   * @return empty where the road ends before
   */
  Optional<Moved> move(LanePoint from, boolean alongS, double distance, List<RoadPoint> route);

  /**
   * Returns how far, along reference lines, a point is behind another one in the direction of the
   * latter's s; negative before it; empty if no way leads there.
   */
  OptionalDouble along(RoadPoint from, RoadPoint to);

  /**
   * A part of a way over roads.
   *
   * @param from s where it begins, in m
   * @param to s where it ends, in m; less than {@code from} against the direction of s
   */
  record Stretch(String road, boolean alongS, double from, double to) {

    /** Returns its length, in m. */
    public double length() {
      return Math.abs(to - from);
    }
  }

  /**
   * Returns the shortest way over some points of lanes, in the direction of traffic.
   *
   * @param waypoints at least two
   * @return its parts in their order; empty if there is no way
   */
  List<Stretch> way(List<LanePoint> waypoints);

  /**
   * Returns why a latitude and longitude have no place on the map, as the end of a sentence; empty
   * if they have one.
   */
  default Optional<String> geoProblem() {
    return Optional.of("there is none");
  }

  /**
   * Returns the place of a latitude and longitude, in degrees, and an altitude.
   *
   * @throws IllegalStateException if there is a {@link #geoProblem()}
   */
  default Pose geo(double latitude, double longitude, double altitude) {
    throw new IllegalStateException(geoProblem().orElseThrow());
  }

  /** Returns a point of a lane in the coordinates of its road. */
  default RoadPoint road(LanePoint point) {
    double t = centre(point.road(), point.s(), point.lane()) + point.offset();
    return new RoadPoint(point.road(), point.s(), t);
  }

  /** Returns a point in the coordinates of the lane that it is on, or of the nearest one. */
  default LanePoint lane(RoadPoint point) {
    int nearest = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int each : lanes(point.road(), point.s())) {
      double off = Math.abs(point.t() - centre(point.road(), point.s(), each));
      if (off < least) {
        nearest = each;
        least = off;
      }
    }
    if (nearest == 0) {
      throw new IllegalArgumentException("road " + point.road() + " has no lanes");
    }
    double centre = centre(point.road(), point.s(), nearest);
    return new LanePoint(point.road(), nearest, point.s(), point.t() - centre);
  }
}

package dev.eventchain.roads;

import dev.eventchain.roads.geometry.PlanPoint;
import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import java.util.List;

/**
 * A path along the middle of linked lanes, as one curve with its own arc length. Before its start
 * and behind its end, it is continued straight. Immutable.
 *
 * <p>Places beside the path are given by their distance to it. On roads that are tilted sideways,
 * the distances are measured along the surface.
 */
public final class LanePath {

  private final PathCurve curve;
  private final double origin;

  /**
   * A place by the coordinates of a path.
   *
   * @param along the arc length, in m; below 0 before its start
   * @param across the distance to the path, positive to the left, in m
   */
  public record Station(double along, double across) {}

  LanePath(PathCurve curve, double origin) {
    this.curve = curve;
    this.origin = origin;
  }

  /** Returns the arc length from start to end, in m. */
  public double length() {
    return curve.length();
  }

  /** Returns the arc length from the start to the position that the path was asked for, in m. */
  public double origin() {
    return origin;
  }

  /** Returns the heading of the path in the plane, in rad. */
  public double heading(double along) {
    return curve.at(along).heading();
  }

  /** Returns the curvature of the path in the plane, in 1/m, positive to the left. */
  public double curvature(double along) {
    return curve.at(along).curvature();
  }

  /** Returns the lanes that the path follows, in its order. */
  public List<LanePosition> starts() {
    return curve.tracks().stream().map(LaneTrack::start).toList();
  }

  /** Returns the position by the lane; before the start and behind the end, that of the end. */
  public LanePosition lanePosition(double along) {
    PathCurve.Place place = curve.place(along);
    return place.track().position(place.s());
  }

  /** Returns whether the path leads along s of its road at a place, or else against it. */
  public boolean isAlongS(double along) {
    return curve.place(along).track().isAlongS();
  }

  /** Returns the pose of a place of the surface, in the direction of the path. */
  public Pose pose(double along, double across) {
    PlanPoint on = curve.at(along);
    double x = on.x() - across * StrictMath.sin(on.heading());
    double y = on.y() + across * StrictMath.cos(on.heading());
    PathCurve.Place place = curve.place(along);
    Road road = place.track().road();
    if (road.isFlat()) {
      return new Pose(x, y, 0, on.heading(), 0, 0);
    }
    double reach = 1 + Math.abs(across) / 2;
    double beyond = along - Math.max(0, Math.min(length(), along));
    double s = place.s() + (place.track().isAlongS() ? beyond : -beyond);
    double[] plan = road.projectPlan(x, y, s - reach, s + reach);
    Pose pose = road.pose(plan[0], plan[1]);
    Pose directed = place.track().isAlongS() ? pose : pose.turned();
    return new Pose(pose.x(), pose.y(), pose.z(), on.heading(), directed.pitch(), directed.roll());
  }

  /**
   * Returns the coordinates of a place, by the part of the path that is nearest to it around
   * another place.
   *
   * @param near the arc length of the other place, such as the last known one; {@code NaN} for the
   *     nearest part of all
   */
  public Station station(double x, double y, double near) {
    Station station = curve.station(x, y, near);
    PathCurve.Place place = curve.place(station.along());
    Road road = place.track().road();
    if (road.isFlat()) {
      return station;
    }
    double reach = 2 + Math.abs(station.across()) / 2;
    double[] on = road.project(x, y, place.s() - reach, place.s() + reach);
    PlanPoint line = road.plan(on[0]);
    return curve.station(
        line.x() - on[1] * StrictMath.sin(line.heading()),
        line.y() + on[1] * StrictMath.cos(line.heading()),
        station.along());
  }
}

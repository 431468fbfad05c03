package dev.eventchain.roads;

import dev.eventchain.roads.geometry.PlanPoint;
import dev.eventchain.roads.geometry.Profile;
import java.util.ArrayList;
import java.util.List;

/** The curve of a path in the plane by its arc length. */
final class PathCurve {

  private final List<LaneTrack> tracks;

  /** Knots: the arc lengths, the places of their tracks, and the points. */
  private final double[] along;

  private final double[] s;
  private final int[] trackOf;
  private final PlanPoint[] points;

  /** A place of a track. */
  record Place(LaneTrack track, double s) {}

  /**
   * Creates a curve.
   *
   * @param tracks in order, at least one
   */
  PathCurve(List<LaneTrack> tracks) {
    this.tracks = List.copyOf(tracks);
    List<Double> places = new ArrayList<>();
    List<Integer> owners = new ArrayList<>();
    for (int i = 0; i < tracks.size(); i++) {
      for (double place : tracks.get(i).knots()) {
        places.add(place);
        owners.add(i);
      }
    }
    this.s = places.stream().mapToDouble(Double::doubleValue).toArray();
    this.trackOf = owners.stream().mapToInt(Integer::intValue).toArray();
    this.along = new double[s.length];
    this.points = new PlanPoint[s.length];
    for (int i = 0; i < s.length; i++) {
      boolean begins = i == 0 || trackOf[i] != trackOf[i - 1];
      double last = i == 0 ? 0 : along[i - 1];
      along[i] = begins ? last : last + trackAt(i).length(s[i - 1], s[i]);
      points[i] = trackAt(i).at(s[i]);
    }
  }

  private LaneTrack trackAt(int knot) {
    return tracks.get(trackOf[knot]);
  }

  List<LaneTrack> tracks() {
    return tracks;
  }

  double length() {
    return along[along.length - 1];
  }

  /** Returns the index of the knot at or before an arc length of which the next one is a part. */
  private int interval(double length) {
    int i = Math.max(0, Math.min(along.length - 2, Profile.indexAt(along, length)));
    while (i > 0 && trackOf[i] != trackOf[i + 1]) {
      i--;
    }
    return i;
  }

  /** Returns the place at an arc length; outside of the curve, that of the nearer end. */
  Place place(double length) {
    double inside = Math.max(0, Math.min(length(), length));
    int i = interval(inside);
    LaneTrack track = trackAt(i);
    double size = along[i + 1] - along[i];
    double share = size > 0 ? (inside - along[i]) / size : 0;
    double place = s[i] + share * (s[i + 1] - s[i]);
    double sense = track.isAlongS() ? 1 : -1;
    for (int round = 0; round < 8; round++) {
      double error = track.length(s[i], place) - (inside - along[i]);
      double next = place - sense * error / Math.max(1e-6, track.stretch(place));
      place = Math.max(Math.min(s[i], s[i + 1]), Math.min(Math.max(s[i], s[i + 1]), next));
      if (Math.abs(error) < 1e-10) {
        break;
      }
    }
    return new Place(track, place);
  }

  /** Returns the point at an arc length. */
  PlanPoint at(double length) {
    if (length < 0) {
      return continued(points[0], length);
    } else if (length > length()) {
      return continued(points[points.length - 1], length - length());
    }
    Place place = place(length);
    return place.track.at(place.s);
  }

  private static PlanPoint continued(PlanPoint point, double by) {
    return new PlanPoint(
        point.x() + by * StrictMath.cos(point.heading()),
        point.y() + by * StrictMath.sin(point.heading()),
        point.heading(),
        0,
        0);
  }

  /** Returns how far a place is ahead of a point of the curve, in the point's direction. */
  private static double ahead(PlanPoint point, double x, double y) {
    return (x - point.x()) * StrictMath.cos(point.heading())
        + (y - point.y()) * StrictMath.sin(point.heading());
  }

  private static double across(PlanPoint point, double x, double y) {
    return (y - point.y()) * StrictMath.cos(point.heading())
        - (x - point.x()) * StrictMath.sin(point.heading());
  }

  LanePath.Station station(double x, double y, double near) {
    int knot = Double.isNaN(near) ? nearestKnot(x, y) : interval(near);
    while (knot > 0 && ahead(points[knot], x, y) < 0) {
      knot--;
    }
    while (knot < points.length - 2 && ahead(points[knot + 1], x, y) > 0) {
      knot++;
    }
    double before = ahead(points[knot], x, y);
    double after = ahead(points[knot + 1], x, y);
    if (before <= 0) {
      return outside(knot, before, x, y, knot == 0);
    } else if (after >= 0) {
      return outside(knot + 1, after, x, y, knot + 2 == points.length);
    }
    return between(x, y, along[knot], along[knot + 1]);
  }

  /** Returns a place that is beside a bend, or, at an end of the curve, before or behind it. */
  private LanePath.Station outside(int knot, double by, double x, double y, boolean atEnd) {
    double beside = across(points[knot], x, y);
    return new LanePath.Station(along[knot] + (atEnd ? by : 0), beside);
  }

  private int nearestKnot(double x, double y) {
    int best = 0;
    for (int i = 1; i < points.length; i++) {
      if (distance(i, x, y) < distance(best, x, y)) {
        best = i;
      }
    }
    return Math.min(best, points.length - 2);
  }

  private double distance(int knot, double x, double y) {
    return StrictMath.hypot(x - points[knot].x(), y - points[knot].y());
  }

  private LanePath.Station between(double x, double y, double from, double to) {
    double low = from;
    double high = to;
    double length = (low + high) / 2;
    PlanPoint point = at(length);
    for (int i = 0; i < 60; i++) {
      double ahead = ahead(point, x, y);
      if (Math.abs(ahead) < 1e-10 || high - low < 1e-11) {
        break;
      } else if (ahead > 0) {
        low = length;
      } else {
        high = length;
      }
      double slope = 1 - point.curvature() * across(point, x, y);
      double next = length + ahead / slope;
      length = slope > 0.05 && next > low && next < high ? next : (low + high) / 2;
      point = at(length);
    }
    return new LanePath.Station(length, across(point, x, y));
  }
}

package dev.eventchain.roads;

import dev.eventchain.roads.geometry.PlanPoint;
import dev.eventchain.roads.geometry.Quadrature;
import dev.eventchain.roads.link.LaneEnd;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Road;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;

/** The middle of a lane within its section, in the direction of a path. */
final class LaneTrack {

  /**
   * A change to another lane of the same section, along a polynomial whose first two derivatives
   * are 0 at both ends.
   *
   * @param lane the id of the other lane
   * @param from s where it begins, in m
   * @param to s where it ends, in m; below the start against s
   */
  record Change(int lane, double from, double to) {

    /** Returns the share of the other lane at a place, or a derivative of an order up to 3. */
    double share(double s, int order) {
      double u = (s - from) / (to - from);
      if (u <= 0 || u >= 1) {
        return order == 0 && u >= 1 ? 1 : 0;
      }
      double value =
          switch (order) {
            case 0 -> u * u * u * (10 + u * (6 * u - 15));
            case 1 -> 30 * u * u * (1 + u * (u - 2));
            case 2 -> 60 * u * (1 + u * (2 * u - 3));
            default -> 60 * (1 + u * (6 * u - 6));
          };
      return value / StrictMath.pow(to - from, order);
    }
  }

  /** Length of the intervals on which arc lengths are integrated, in m. */
  private static final double INTERVAL = 2;

  private static final int[][] BINOMIALS = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};

  private final LaneEnd entry;
  private final LaneSection section;

  private final Optional<Change> change;

  LaneTrack(LaneEnd entry, Optional<Change> change) {
    this.entry = entry;
    this.section = entry.laneSection();
    this.change = change;
  }

  /** Returns the end at which the track leaves the section. */
  LaneEnd exit() {
    int lane = change.map(Change::lane).orElse(entry.lane());
    return new LaneEnd(entry.road(), entry.section(), lane, !entry.atEnd());
  }

  Road road() {
    return entry.road();
  }

  /** Returns the position by the lane of which there is more at a place. */
  LanePosition position(double s) {
    boolean changed = change.isPresent() && change.get().share(s, 0) > 0.5;
    int lane = changed ? change.get().lane() : entry.lane();
    return new LanePosition(road().id(), lane, s, centre(s, 0) - section.centre(lane, s));
  }

  /** Returns t of the track, or a derivative of an order up to 3. */
  private double centre(double s, int order) {
    double centre = section.centre(entry.lane(), s, order);
    if (change.isEmpty()) {
      return centre;
    }
    // The product rule for the share of the other lane times the distance to it.
    int[] binomial = BINOMIALS[order];
    for (int i = 0; i <= order; i++) {
      int lane = change.get().lane();
      double distance =
          section.centre(lane, s, order - i) - section.centre(entry.lane(), s, order - i);
      centre += binomial[i] * change.get().share(s, i) * distance;
    }
    return centre;
  }

  boolean isAlongS() {
    return !entry.atEnd();
  }

  LanePosition start() {
    return new LanePosition(road().id(), entry.lane(), entry.s(), 0);
  }

  /** Returns s at places between which the middle is smooth and short, in the track's order. */
  List<Double> knots() {
    SortedSet<Double> breaks = new TreeSet<>();
    breaks.add(section.start());
    breaks.add(section.end());
    change.ifPresent(found -> breaks.addAll(List.of(found.from(), found.to())));
    List<double[]> all = new ArrayList<>(section.breaks());
    all.add(road().line().starts());
    all.add(road().laneOffset().starts());
    for (double[] starts : all) {
      for (double start : starts) {
        if (start > section.start() && start < section.end()) {
          breaks.add(start);
        }
      }
    }
    List<Double> knots = new ArrayList<>();
    Double last = null;
    for (double next : breaks) {
      if (last != null) {
        divide(last, next, knots);
      }
      last = next;
    }
    knots.add(section.end());
    if (!isAlongS()) {
      Collections.reverse(knots);
    }
    return knots;
  }

  private void divide(double from, double to, List<Double> knots) {
    double middle = (from + to) / 2;
    boolean straight =
        road().line().isStraight(from, to)
            && change.isEmpty()
            && centre(middle, 2) == 0
            && centre(middle, 3) == 0;
    int parts = straight ? 1 : (int) Math.ceil((to - from) / INTERVAL);
    for (int i = 0; i < parts; i++) {
      knots.add(from + (to - from) * i / parts);
    }
  }

  /** Returns the arc length between two places, positive also against s. */
  double length(double from, double to) {
    return Math.abs(Quadrature.integral(this::stretch, from, to));
  }

  /** Returns the arc length of the whole track, in m. */
  double length() {
    return lengthTo(exit().s());
  }

  /** Returns the arc length from where the track begins to a place, in m. */
  double lengthTo(double s) {
    List<Double> knots = knots();
    double length = 0;
    for (int i = 1; i < knots.size(); i++) {
      double from = knots.get(i - 1);
      double to = knots.get(i);
      boolean within = isAlongS() ? to <= s : to >= s;
      boolean reaches = isAlongS() ? from < s : from > s;
      length += within ? length(from, to) : reaches ? length(from, s) : 0;
    }
    return length;
  }

  /** Returns the arc length of the middle for 1 m of s. */
  double stretch(double s) {
    double ahead = 1 - road().curvature(s) * centre(s, 0);
    return StrictMath.hypot(ahead, centre(s, 1));
  }

  /** Returns the point of the middle, in the direction of the track. */
  PlanPoint at(double s) {
    PlanPoint line = road().plan(s);
    double t = centre(s, 0);
    double slope = centre(s, 1);
    double bend = centre(s, 2);
    double k = line.curvature();
    double ahead = 1 - k * t;
    // The derivatives of the line's point plus t along its normal, by Frenet's formulas.
    double bends = ahead * (k * ahead + bend) + slope * (line.sharpness() * t + 2 * k * slope);
    double curvature = bends / StrictMath.pow(Math.max(1e-9, StrictMath.hypot(ahead, slope)), 3);
    double heading = line.heading() + StrictMath.atan2(slope, ahead) + (isAlongS() ? 0 : Math.PI);
    return new PlanPoint(
        line.x() - t * StrictMath.sin(line.heading()),
        line.y() + t * StrictMath.cos(line.heading()),
        heading,
        isAlongS() ? curvature : -curvature,
        0);
  }
}

package dev.eventchain.roads;

import dev.eventchain.roads.geometry.BoxTree;
import dev.eventchain.roads.geometry.BoxTree.Box;
import dev.eventchain.roads.geometry.BoxTree.Entry;
import dev.eventchain.roads.geometry.PlanPoint;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** Search for the road at a place. */
final class Locator {

  /** Length of the parts that roads are divided into, in m. */
  private static final double PART = 25;

  /** Turn of a part, in rad, so that the nearest point of its line is the only one. */
  private static final double TURN = 0.5;

  /** Distance to a road that is rounding, in m. */
  private static final double ROUNDING = 1e-6;

  /** Width of the wedge that a bend in a road's line leaves on its outside, in m. */
  private static final double WEDGE = 0.1;

  private final BoxTree<Part> tree;

  private record Part(Road road, double from, double to) {}

  /**
   * A road at or near a place.
   *
   * @param distance to the road's surface in the plane, in m; 0 on it
   * @param fromMiddle the distance to the middle of the lane, in m
   */
  private record Candidate(
      Road road, double s, double t, double distance, double fromMiddle, OptionalInt lane) {

    RoadPosition position() {
      return new RoadPosition(road.id(), s, t, lane);
    }
  }

  Locator(Collection<Road> roads) {
    List<Entry<Part>> entries = new ArrayList<>();
    roads.forEach(road -> add(road, entries));
    tree = new BoxTree<>(entries);
  }

  private static void add(Road road, List<Entry<Part>> entries) {
    double[] starts = road.line().starts();
    for (int i = 0; i < starts.length; i++) {
      double from = road.inside(starts[i]);
      double to = i + 1 < starts.length ? road.inside(starts[i + 1]) : road.length();
      double turned = turn(road, from, to);
      int parts = (int) Math.max(1, Math.ceil(Math.max((to - from) / PART, turned / TURN)));
      for (int j = 0; j < parts; j++) {
        Part part =
            new Part(road, from + (to - from) * j / parts, from + (to - from) * (j + 1) / parts);
        entries.add(new Entry<>(box(part), part));
      }
    }
  }

  private static double turn(Road road, double from, double to) {
    double most = 0;
    for (int i = 0; i <= 8; i++) {
      most = Math.max(most, Math.abs(road.curvature(from + (to - from) * i / 8)));
    }
    return most * (to - from);
  }

  /** Returns a box that contains the surface of a part, by points at both of its edges. */
  private static Box box(Part part) {
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    double widest = 0;
    for (int i = 0; i <= 4; i++) {
      double s = part.from + (part.to - part.from) * i / 4;
      LaneSection section = part.road.section(s);
      PlanPoint line = part.road.plan(s);
      for (double t : new double[] {section.leftEdge(s), section.rightEdge(s), 0}) {
        double x = line.x() - t * StrictMath.sin(line.heading());
        double y = line.y() + t * StrictMath.cos(line.heading());
        minX = Math.min(minX, x);
        minY = Math.min(minY, y);
        maxX = Math.max(maxX, x);
        maxY = Math.max(maxY, y);
        widest = Math.max(widest, Math.abs(t));
      }
    }
    // Between the points, edges bulge by the sagitta, and widths by what the polynomials do.
    double margin = 1 + 0.1 * widest + (part.to - part.from) * TURN / 8;
    return new Box(minX - margin, minY - margin, maxX + margin, maxY + margin);
  }

  Optional<RoadPosition> locate(double x, double y, Optional<Road> preferred) {
    List<Candidate> on = new ArrayList<>();
    tree.visit(
        x,
        y,
        part -> {
          Candidate candidate = candidate(part, x, y);
          if (candidate.distance <= WEDGE && candidate.lane.isPresent()) {
            on.add(candidate);
          }
          return 0;
        });
    Candidate best = null;
    for (Candidate each : on) {
      best = best == null || isBetter(each, best, preferred) ? each : best;
    }
    return Optional.ofNullable(best).map(Candidate::position);
  }

  private static boolean isBetter(Candidate one, Candidate other, Optional<Road> preferred) {
    boolean isOn = one.distance <= ROUNDING;
    if (isOn != other.distance <= ROUNDING) {
      return isOn;
    }
    boolean isPreferred = preferred.filter(road -> road == one.road).isPresent();
    boolean otherIs = preferred.filter(road -> road == other.road).isPresent();
    return isPreferred == otherIs ? one.fromMiddle < other.fromMiddle : isPreferred;
  }

  RoadPosition nearest(double x, double y) {
    Candidate[] best = new Candidate[1];
    tree.visit(
        x,
        y,
        part -> {
          Candidate candidate = candidate(part, x, y);
          boolean better =
              best[0] == null
                  || candidate.distance < best[0].distance
                  || (candidate.distance == best[0].distance
                      && candidate.fromMiddle < best[0].fromMiddle);
          best[0] = better ? candidate : best[0];
          return best[0].distance;
        });
    return best[0].position();
  }

  private static Candidate candidate(Part part, double x, double y) {
    Road road = part.road;
    double[] found = road.project(x, y, part.from, part.to);
    double s = found[0];
    double t = found[1];
    LaneSection section = road.section(s);
    OptionalInt lane = section.laneAt(s, t);
    Pose on = road.pose(s, t);
    double missed = StrictMath.hypot(x - on.x(), y - on.y());
    double beside = Math.max(0, Math.max(t - section.leftEdge(s), section.rightEdge(s) - t));
    double middle = lane.isPresent() ? section.centre(lane.getAsInt(), s) : 0;
    return new Candidate(road, s, t, StrictMath.hypot(beside, missed), Math.abs(t - middle), lane);
  }
}

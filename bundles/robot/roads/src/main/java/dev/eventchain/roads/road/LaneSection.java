package dev.eventchain.roads.road;

import dev.eventchain.roads.geometry.Profile;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** The lanes of a part of a road. Immutable. */
public final class LaneSection {

  /** Distance to the outermost edge that is rounding, in m. */
  private static final double ROUNDING = 1e-9;

  private final double start;
  private final double end;
  private final Profile offset;
  private final List<Lane> left;
  private final List<Lane> right;
  private final Lane centre;

  /**
   * Creates a section.
   *
   * @param offset t of lane 0
   * @param left the lanes from 1 on
   * @param right the lanes from -1 down
   */
  public LaneSection(
      double start, double end, Profile offset, List<Lane> left, List<Lane> right, Lane centre) {
    this.start = start;
    this.end = end;
    this.offset = offset;
    this.left = List.copyOf(left);
    this.right = List.copyOf(right);
    this.centre = centre;
  }

  /** Returns the parts before and behind a place inside it, with the same lanes. */
  List<LaneSection> divided(double s) {
    return List.of(
        new LaneSection(start, s, offset, left, right, centre),
        new LaneSection(s, end, offset, left, right, centre));
  }

  /** Returns s where it begins, in m. */
  public double start() {
    return start;
  }

  /** Returns s where it ends, in m. */
  public double end() {
    return end;
  }

  /** Returns all lanes from left to right, with lane 0. */
  public List<Lane> lanes() {
    List<Lane> lanes = new ArrayList<>(left);
    Collections.reverse(lanes);
    lanes.add(centre);
    lanes.addAll(right);
    return lanes;
  }

  /** Returns a lane. */
  public Optional<Lane> lane(int id) {
    List<Lane> side = id < 0 ? right : left;
    int index = Math.abs(id) - 1;
    return id == 0
        ? Optional.of(centre)
        : index < side.size() ? Optional.of(side.get(index)) : Optional.empty();
  }

  /** Returns t of a lane's edge away from lane 0, in m; of lane 0, its place. */
  public double outerEdge(int lane, double s) {
    return edge(lane, s, 0);
  }

  /** Returns t of a lane's edge towards lane 0, in m. */
  public double innerEdge(int lane, double s) {
    return edge(lane - Integer.signum(lane), s, 0);
  }

  /** Returns t of a lane's middle, in m. */
  public double centre(int lane, double s) {
    return centre(lane, s, 0);
  }

  /** Returns a lane's width, in m. */
  public double width(int lane, double s) {
    return Math.abs(outerEdge(lane, s) - innerEdge(lane, s));
  }

  /** Returns t of a lane's middle, or a derivative with respect to s of an order up to 3. */
  public double centre(int lane, double s, int order) {
    return (edge(lane, s, order) + edge(lane - Integer.signum(lane), s, order)) / 2;
  }

  private double edge(int lane, double s, int order) {
    List<Lane> side = lane < 0 ? right : left;
    if (Math.abs(lane) > side.size()) {
      throw new IllegalArgumentException("there is no lane " + lane);
    }
    double edge = 0;
    for (int i = 0; i < Math.abs(lane); i++) {
      edge = side.get(i).outerEdge(edge, s, order);
    }
    return edge + offset.at(s, order);
  }

  /** Returns t of the left edge of the outermost lane, in m. */
  public double leftEdge(double s) {
    return outerEdge(left.size(), s);
  }

  /** Returns t of the right edge of the outermost lane, in m. */
  public double rightEdge(double s) {
    return outerEdge(-right.size(), s);
  }

  /** Returns the lane at a place; that of the left at an edge, and empty beside all lanes. */
  public OptionalInt laneAt(double s, double t) {
    double inner = offset.at(s);
    List<Lane> side = t < inner ? right : left;
    double edge = 0;
    for (Lane lane : side) {
      edge = lane.outerEdge(edge, s, 0);
      if (t < inner ? t >= inner + edge : t < inner + edge) {
        return OptionalInt.of(lane.id());
      }
    }
    boolean onEdge = Math.abs(t - inner - edge) < ROUNDING;
    return onEdge
        ? OptionalInt.of(side.isEmpty() ? 0 : side.get(side.size() - 1).id())
        : OptionalInt.empty();
  }

  /** Returns where the lanes' polynomials begin. */
  public List<double[]> breaks() {
    return lanes().stream().map(Lane::breaks).toList();
  }

  /** Returns the lateral place from which on lanes are level on a side; infinite if none is. */
  double level(boolean onLeft, double s) {
    for (Lane lane : onLeft ? left : right) {
      if (lane.isLevel()) {
        return Math.abs(innerEdge(lane.id(), s));
      }
    }
    return Double.POSITIVE_INFINITY;
  }
}

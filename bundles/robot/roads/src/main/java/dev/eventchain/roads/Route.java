package dev.eventchain.roads;

import java.util.List;

/**
 * A way over roads.
 *
 * @param legs in order, at least one
 */
public record Route(List<Leg> legs) {

  /**
   * A part of a way.
   *
   * @param road the id of the road
   * @param alongS whether it leads along s, or else against it
   * @param from s where it begins, in m
   * @param to s where it ends, in m
   */
  public record Leg(String road, boolean alongS, double from, double to) {

    /** Returns the length, in m. */
    public double length() {
      return Math.abs(to - from);
    }
  }

  /** Refuses a way without a part. */
  public Route {
    legs = List.copyOf(legs);
    if (legs.isEmpty()) {
      throw new IllegalArgumentException("a route has a leg");
    }
  }

  /** Returns the length along the reference lines, in m. */
  public double length() {
    return legs.stream().mapToDouble(Leg::length).sum();
  }
}

package dev.eventchain.simulation.world;

/**
 * The way of an actor's middle in time, which is known up to the next moment of the trace at least;
 * what is after that is what it would be if nothing begins. Times are in s, from the start.
 */
interface Course {

  /** Returns the place of the middle, and the direction of the front. */
  Road.Place place(Road road, double seconds);

  /**
   * Returns the position along the road, in m from the start of the ego's front bumper, and left of
   * the centre line of the ego's lane.
   */
  Road.Station station(double seconds);

  /** Returns the direction of the front relative to that of the road, in rad. */
  double heading(double seconds);

  /** Returns the speed along the road, in m/s; negative if it is oncoming. */
  double speedAlong(double seconds);

  /** Returns the speed across the road, in m/s; positive to the left. */
  double speedAcross(double seconds);

  /** Returns whether nothing moves from a time on. */
  boolean restsFrom(double seconds);

  /**
   * Returns an upper bound of the speed of any point, in m/s.
   *
   * @param reach of the farthest point from the middle, in m
   */
  double fastest(double reach);

  /** Returns whether the actor is there at a time. */
  boolean exists(double seconds);
}

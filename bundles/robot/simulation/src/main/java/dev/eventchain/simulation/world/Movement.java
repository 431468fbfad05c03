package dev.eventchain.simulation.world;

import java.util.Optional;
import java.util.function.LongPredicate;

/** Motion of the ego in a time step, to find contacts within it and not only at its end. */
final class Movement {

  /** Minimum step of the search for a contact, in ns. */
  private static final long SHORTEST = 10_000L;

  /** Upper bound of the change of the ego's speed in a time step, in m/s. */
  private static final double CHANGE = 0.5;

  private final EgoMotion before;
  private final long from;
  private final long until;
  private final Road road;
  private final double travelled;
  private final double fastest;

  /**
   * Creates a time step.
   *
   * @param before the ego at its start
   * @param from in ns
   * @param until in ns, at most {@link World#TRACE_STEP} later
   * @param travelled approximate position of the ego along the road, in m
   */
  Movement(EgoMotion before, long from, long until, Road road, double travelled) {
    this.before = before;
    this.from = from;
    this.until = until;
    this.road = road;
    this.travelled = travelled;
    this.fastest = before.fastest(CHANGE);
  }

  /** Returns the ego at a time of the step. */
  EgoMotion at(long time) {
    EgoMotion motion = before.copy();
    motion.advance(World.seconds(time - from));
    return motion;
  }

  /**
   * Returns the contact with an actor. The search advances in steps in which the two cannot meet
   * (conservative advancement), so that no contact is missed.
   */
  Optional<Contact> contact(Actor actor) {
    double closing = fastest + actor.fastest();
    long apart = from;
    double distance = distance(actor, from);
    if (distance <= 0.0) {
      return Optional.of(touch(actor, from));
    }
    while (distance <= closing * World.seconds(until - apart)) {
      long step = Math.max(SHORTEST, (long) (distance / closing * 1e9));
      long next = Math.min(until, apart + step);
      distance = distance(actor, next);
      if (distance <= 0.0) {
        return Optional.of(touch(actor, first(apart, next, time -> distance(actor, time) <= 0.0)));
      }
      apart = next;
      if (apart == until) {
        break;
      }
    }
    return Optional.empty();
  }

  private double distance(Actor actor, long time) {
    return at(time).body().separation(actor.body(road, World.seconds(time)));
  }

  private Contact touch(Actor actor, long time) {
    EgoMotion ego = at(time);
    return Contact.of(time, ego, actor, road);
  }

  /** Returns whether the front touches a wall next to the road. */
  boolean leavesTheRoad(long time) {
    Road.Place front = at(time).front();
    double across = road.station(front.x(), front.y(), travelled).across();
    return Math.abs(across) + before.shape().width() / 2 >= Road.WALL_DISTANCE;
  }

  /** Returns the time at which the front touches a wall, if it does so in this step. */
  long leaving() {
    return first(from, until, this::leavesTheRoad);
  }

  /** Returns the instant at which a condition becomes true, to a nanosecond. */
  private static long first(long before, long after, LongPredicate isTrue) {
    long not = before;
    long found = after;
    while (found - not > 1) {
      long middle = (not + found) / 2;
      if (isTrue.test(middle)) {
        found = middle;
      } else {
        not = middle;
      }
    }
    return found;
  }
}

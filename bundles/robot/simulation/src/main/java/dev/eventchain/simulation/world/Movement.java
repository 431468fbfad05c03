package dev.eventchain.simulation.world;

import java.util.Optional;
import java.util.function.LongPredicate;

/**
 * How the ego moves in a piece of time, to find out whether it touches something on the way: not
 * only where it ends.
 */
final class Movement {

  /** The shortest step of the search for a touch, in ns. */
  private static final long SHORTEST = 10_000L;

  /** More than the speed of the ego changes in a piece of time, in m/s. */
  private static final double CHANGE = 0.5;

  /** At least the way from the ego's rear axle to its farthest corner, in m. */
  private static final double FARTHEST = 4.0;

  private final EgoMotion before;
  private final long from;
  private final long until;
  private final Road road;
  private final double travelled;
  private final double fastest;

  /**
   * A piece of time.
   *
   * @param before the ego at its begin
   * @param from in ns
   * @param until in ns, at most {@link World#TRACE_STEP} later
   * @param travelled about how far the ego is along the road, in m
   */
  Movement(EgoMotion before, long from, long until, Road road, double travelled) {
    this.before = before;
    this.from = from;
    this.until = until;
    this.road = road;
    this.travelled = travelled;
    double turning = before.speed() > 0.0 ? Math.abs(before.yawRate() / before.speed()) : 0.0;
    this.fastest = (before.speed() + CHANGE) * (1.0 + turning * FARTHEST);
  }

  /** The ego at a time of the piece. */
  EgoMotion at(long time) {
    EgoMotion motion = before.copy();
    motion.advance(World.seconds(time - from));
    return motion;
  }

  /**
   * The touch with an actor: the search continues in steps in which the two cannot meet
   * (conservative advancement), so that nothing is passed through.
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
    return Contact.of(time, ego.front(), ego.velocity(), actor, road);
  }

  /** Whether the front touches a wall next to the road. */
  boolean leavesTheRoad(long time) {
    Road.Place front = at(time).front();
    double across = road.station(front.x(), front.y(), travelled).across();
    return Math.abs(across) + EgoVehicle.WIDTH / 2 >= Road.WALL_DISTANCE;
  }

  /** When the front touches a wall, if it does so in this piece. */
  long leaving() {
    return first(from, until, this::leavesTheRoad);
  }

  /** The instant at which something becomes true, to a nanosecond. */
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

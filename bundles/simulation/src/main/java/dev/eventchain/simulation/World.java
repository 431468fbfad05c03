package dev.eventchain.simulation;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * The road with the ego and the other vehicles on it, as point masses along the lane. Gaps are
 * measured from bumper to bumper. An impact ends the movement of time.
 */
final class World {

  /** Distance of two states in the trace, in ns. */
  static final long TRACE_STEP = 10_000_000L;

  private record Pending(long effectiveAt, VehicleCommand command) {}

  private final EgoVehicle vehicle;
  private final List<TargetVehicle> targets;
  private final EgoMotion ego;
  private final Trace trace;
  private final Deque<Pending> pending = new ArrayDeque<>();
  private long now;
  private double impactSpeed = Double.NaN;

  World(EgoVehicle vehicle, List<TargetVehicle> targets) {
    this(vehicle, targets, new Trace());
  }

  /**
   * A world.
   *
   * @param trace where what happens is recorded; empty
   */
  World(EgoVehicle vehicle, List<TargetVehicle> targets, Trace trace) {
    this.trace = trace;
    this.vehicle = vehicle;
    this.targets = List.copyOf(targets);
    this.ego = new EgoMotion(vehicle);
    record();
  }

  /** Simulated time, in ns. */
  long now() {
    return now;
  }

  /** The ego's way since the start, in m. */
  double egoPosition() {
    return ego.position();
  }

  /** The ego's speed, in m/s. */
  double egoSpeed() {
    return ego.speed();
  }

  /** Whether the ego has hit another vehicle. */
  boolean impacted() {
    return !Double.isNaN(impactSpeed);
  }

  /** Everything that happened up to now. */
  Trace trace() {
    return trace;
  }

  /** All other vehicles. */
  List<TargetVehicle> targets() {
    return targets;
  }

  /** Place of a vehicle's rear bumper ahead of the ego's front bumper, in m. */
  double distanceTo(TargetVehicle target) {
    return target.position(seconds(now)) - ego.position();
  }

  /**
   * Takes a command; it takes effect after the delay of the brake.
   *
   * @param time when it was published, in ns: not before now and not before the last one
   */
  void command(long time, VehicleCommand command) {
    pending.add(new Pending(time + nanoseconds(vehicle.brakeDelay()), command));
    trace.command(time, command);
  }

  /** Moves time on, or up to the impact. */
  void advanceTo(long until) {
    while (now < until && !impacted()) {
      long next = Math.min(until, (now / TRACE_STEP + 1) * TRACE_STEP);
      Pending following = pending.peek();
      if (following != null && following.effectiveAt() <= now) {
        ego.follow(pending.remove().command());
        continue;
      }
      if (following != null) {
        next = Math.min(next, following.effectiveAt());
      }
      advancePiece(next);
    }
  }

  private void advancePiece(long until) {
    EgoMotion before = ego.copy();
    ego.advance(seconds(until - now));
    Optional<TargetVehicle> hit = nearest(until, ego);
    if (hit.isPresent() && gap(hit.get(), until, ego) <= 0.0) {
      impact(before, until, hit.get());
    } else {
      now = until;
    }
    if (impacted() || now % TRACE_STEP == 0) {
      record();
    }
  }

  /** Finds the instant of the impact to a nanosecond. */
  private void impact(EgoMotion before, long until, TargetVehicle target) {
    long apart = now;
    long touching = until;
    while (touching - apart > 1) {
      long middle = (apart + touching) / 2;
      EgoMotion tried = before.copy();
      tried.advance(seconds(middle - now));
      if (gap(target, middle, tried) > 0.0) {
        apart = middle;
      } else {
        touching = middle;
      }
    }
    EgoMotion touched = before.copy();
    touched.advance(seconds(touching - now));
    now = touching;
    impactSpeed = Math.max(0.0, touched.speed() - target.speed(seconds(touching)));
    trace.impact(impactSpeed);
  }

  private void record() {
    trace.state(state());
  }

  /** What is true at this moment, with the last command. */
  Trace moment() {
    return trace.moment(state());
  }

  private Trace.State state() {
    Optional<TargetVehicle> ahead = nearest(now, ego);
    double gap = ahead.map(target -> gap(target, now, ego)).orElse(Double.POSITIVE_INFINITY);
    double closing = ego.speed() - ahead.map(target -> target.speed(seconds(now))).orElse(0.0);
    double timeToCollision =
        ahead.isPresent() && closing > 0.0
            ? Math.max(0.0, gap) / closing
            : Double.POSITIVE_INFINITY;
    return new Trace.State(
        now,
        ego.speed(),
        Math.max(0.0, gap),
        timeToCollision,
        ego.deceleration(),
        ego.position(),
        ahead.map(target -> target.speed(seconds(now))).orElse(Double.NaN));
  }

  /** The nearest vehicle that is in the ego's path and not behind it. */
  private Optional<TargetVehicle> nearest(long time, EgoMotion motion) {
    TargetVehicle nearest = null;
    for (TargetVehicle target : targets) {
      double gap = gap(target, time, motion);
      if (target.inPath()
          && gap > -target.length()
          && (nearest == null || gap < gap(nearest, time, motion))) {
        nearest = target;
      }
    }
    return Optional.ofNullable(nearest);
  }

  private static double gap(TargetVehicle target, long time, EgoMotion motion) {
    return target.position(seconds(time)) - motion.position();
  }

  static double seconds(long nanoseconds) {
    return nanoseconds / 1e9;
  }

  static long nanoseconds(double seconds) {
    return Math.round(seconds * 1e9);
  }
}

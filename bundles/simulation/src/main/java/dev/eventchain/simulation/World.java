package dev.eventchain.simulation;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;

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

  /** How the ego moves; not to be changed. */
  EgoMotion ego() {
    return ego;
  }

  /** The ego's speed, in m/s; never negative. */
  double egoSpeed() {
    return ego.speed();
  }

  /** Whether the ego has hit another vehicle or a wall beside the road. */
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
    Optional<TargetVehicle> hit = touched(until, before, ego);
    if (hit.isPresent()) {
      TargetVehicle target = hit.get();
      boolean aside = !target.inPath(before.offset());
      impact(before, until, (time, tried) -> touches(target, time, tried, aside), target::speed);
    } else if (leavesTheRoad(ego)) {
      impact(before, until, (time, tried) -> leavesTheRoad(tried), time -> 0.0);
    } else {
      now = until;
    }
    if (impacted() || now % TRACE_STEP == 0) {
      record();
    }
  }

  private interface Touch {
    boolean at(long time, EgoMotion motion);
  }

  /**
   * Finds the instant of an impact to a nanosecond.
   *
   * @param speedOfOther that of what is hit, in m/s, after some seconds
   */
  private void impact(EgoMotion before, long until, Touch touch, DoubleUnaryOperator speedOfOther) {
    long apart = now;
    long touching = until;
    while (touching - apart > 1) {
      long middle = (apart + touching) / 2;
      EgoMotion tried = before.copy();
      tried.advance(seconds(middle - now));
      if (touch.at(middle, tried)) {
        touching = middle;
      } else {
        apart = middle;
      }
    }
    EgoMotion touched = before.copy();
    touched.advance(seconds(touching - now));
    now = touching;
    impactSpeed = Math.abs(touched.velocity() - speedOfOther.applyAsDouble(seconds(touching)));
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
    double closing = ego.velocity() - ahead.map(target -> target.speed(seconds(now))).orElse(0.0);
    double timeToCollision =
        ahead.isPresent() && closing > 0.0
            ? Math.max(0.0, gap) / closing
            : Double.POSITIVE_INFINITY;
    return new Trace.State(
        now,
        ego.velocity(),
        Math.max(0.0, gap),
        timeToCollision,
        ego.deceleration(),
        ego.position(),
        ahead.map(target -> target.speed(seconds(now))).orElse(Double.NaN),
        new Trace.Pose(ego.offset(), ego.heading(), ego.yawRate()));
  }

  /** A vehicle that the ego has driven into, forwards, backwards or aside. */
  private Optional<TargetVehicle> touched(long time, EgoMotion before, EgoMotion motion) {
    return targets.stream()
        .filter(target -> touches(target, time, motion, !target.inPath(before.offset())))
        .findFirst();
  }

  /** Whether the front touches a wall beside the road. */
  private static boolean leavesTheRoad(EgoMotion motion) {
    return Math.abs(motion.offset()) + EgoVehicle.WIDTH / 2 >= RoadScene.WALL_DISTANCE;
  }

  /**
   * Whether bodies overlap; who is hit from behind has not driven into anybody.
   *
   * @param aside whether the other one was beside the ego a moment ago
   */
  private static boolean touches(TargetVehicle target, long time, EgoMotion motion, boolean aside) {
    double gap = gap(target, time, motion);
    boolean ahead = gap <= 0.0 && gap > -target.length();
    boolean beside = gap <= -target.length() && gap >= -target.length() - EgoVehicle.LENGTH;
    return target.inPath(motion.offset())
        && (ahead || (beside && (motion.velocity() < 0.0 || aside)));
  }

  /** The nearest vehicle that is in the ego's path and not behind it. */
  private Optional<TargetVehicle> nearest(long time, EgoMotion motion) {
    TargetVehicle nearest = null;
    for (TargetVehicle target : targets) {
      double gap = gap(target, time, motion);
      if (target.inPath(motion.offset())
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

package dev.eventchain.simulation.world;

import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The road with the ego and all others on it, as boxes that move in the plane. Gaps are measured
 * along the road, from bumper to bumper. An impact of the ego ends the movement of time.
 */
public final class World {

  /** Distance of two states in the trace, in ns. */
  public static final long TRACE_STEP = 10_000_000L;

  private record Pending(long effectiveAt, VehicleCommand command) {}

  private final Situation situation;
  private final Trace trace;
  private final Deque<Pending> pending = new ArrayDeque<>();
  private final Set<Actor> gone = new HashSet<>();
  private EgoMotion ego;
  private long now;

  /** About how far the ego is along the road, in m: a bend may be more than a full circle. */
  private double travelled;

  public World(EgoVehicle vehicle, List<Actor> actors) {
    this(Situation.straight(vehicle, actors), new Trace());
  }

  /**
   * A world.
   *
   * @param trace where what happens is recorded; empty
   */
  public World(Situation situation, Trace trace) {
    this.trace = trace;
    this.situation = situation;
    this.ego = new EgoMotion(situation.ego());
    letDrive();
    record();
  }

  /** Simulated time, in ns. */
  public long now() {
    return now;
  }

  /** How the ego moves; not to be changed. */
  public EgoMotion ego() {
    return ego;
  }

  /** The ego's speed, in m/s; never negative. */
  public double egoSpeed() {
    return ego.speed();
  }

  /** Whether the ego hit somebody or a wall next to the road, or was hit, but not from behind. */
  public boolean impacted() {
    return trace.impactSpeed().isPresent();
  }

  /** Everything that happened up to now. */
  public Trace trace() {
    return trace;
  }

  public Road road() {
    return situation.road();
  }

  /** All others, also those that are gone. */
  public List<Actor> allActors() {
    return situation.actors();
  }

  /** All others, but for those that drove into the ego's rear. */
  public List<Actor> actors() {
    List<Actor> actors = situation.actors();
    return gone.isEmpty() ? actors : actors.stream().filter(each -> !gone.contains(each)).toList();
  }

  /** Where the ego's front bumper is on the road. */
  public Road.Station station() {
    Road.Place front = ego.front();
    return road().station(front.x(), front.y(), travelled);
  }

  private double heading(Road.Station station) {
    return ego.front().heading() - road().heading(station.along());
  }

  /**
   * Takes a command; it takes effect after the delay of the brake.
   *
   * @param time when it was published, in ns: not before now and not before the last one
   */
  public void command(long time, VehicleCommand command) {
    pending.add(new Pending(time + nanoseconds(situation.ego().brakeDelay()), command));
    trace.command(time, command);
  }

  /** Moves time on, or up to the impact. */
  public void advanceTo(long until) {
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
    Movement movement = new Movement(ego.copy(), now, until, situation.road(), travelled);
    ego.advance(seconds(until - now));
    travelled += ego.velocity() * seconds(until - now);
    now = until;
    Optional<Contact> contact =
        actors().stream()
            .filter(Actor::obstructs)
            .flatMap(actor -> movement.contact(actor).stream())
            .min(Comparator.comparingLong(Contact::time));
    contact.filter(Contact::fromBehind).ifPresent(this::hitFromBehind);
    Optional<Contact> impact = contact.filter(each -> !each.fromBehind());
    if (impact.isPresent()) {
      end(movement, impact.get().time());
      trace.impact(impact.get().speed(), impact.get().words());
    } else if (movement.leavesTheRoad(until)) {
      end(movement, movement.leaving());
      trace.impact(ego.speed(), "the ego left the road");
    }
    if (impacted() || now % TRACE_STEP == 0) {
      letDrive();
      record();
    }
  }

  private void end(Movement movement, long time) {
    now = time;
    ego = movement.at(time);
  }

  /** What happens to a vehicle that is hit is not simulated: the other one is gone from then on. */
  private void hitFromBehind(Contact contact) {
    gone.add(contact.other());
    trace.hitFromBehind(contact);
  }

  /** What the driver does until he looks again. */
  private void letDrive() {
    HumanDriver driver = situation.driver();
    if (ego.held()) {
      ego.drive(driver.acceleration(seconds(now), ego.speed()));
    }
    if (ego.steered() && driver.steers(road())) {
      Road.Station station = station();
      // At the rear axle, which follows the bend, the road points less far into it.
      double behind = road().curvature() * situation.ego().chassis().frontOverhang();
      double heading = heading(station) + behind;
      ego.steer(driver.curvature(road(), station, heading, ego.speed(), seconds(now)));
    }
  }

  private void record() {
    trace.state(state());
  }

  /** What is true at this moment, with the last command. */
  public Trace moment() {
    return trace.moment(state());
  }

  private Trace.State state() {
    Road.Station station = station();
    double time = seconds(now);
    Optional<Actor> ahead = nearest(station);
    double gap =
        ahead.map(actor -> actor.rear(time) - station.along()).orElse(Double.POSITIVE_INFINITY);
    double closing = ego.velocity() - ahead.map(actor -> actor.speedAlong(time)).orElse(0.0);
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
        station.along(),
        ahead.map(actor -> actor.speedAlong(time)).orElse(Double.NaN),
        new Trace.Pose(station.across(), heading(station), ego.yawRate()));
  }

  /** The nearest that is in the ego's path and not behind it. */
  private Optional<Actor> nearest(Road.Station station) {
    double time = seconds(now);
    Actor nearest = null;
    for (Actor actor : actors()) {
      double gap = actor.rear(time) - station.along();
      boolean inPath =
          Math.abs(actor.across(time) - station.across())
              < EgoVehicle.WIDTH / 2 + actor.breadth(time);
      if (actor.obstructs()
          && inPath
          && gap > -2 * actor.reach(time)
          && (nearest == null || gap < nearest.rear(time) - station.along())) {
        nearest = actor;
      }
    }
    return Optional.ofNullable(nearest);
  }

  public static double seconds(long nanoseconds) {
    return nanoseconds / 1e9;
  }

  public static long nanoseconds(double seconds) {
    return Math.round(seconds * 1e9);
  }
}

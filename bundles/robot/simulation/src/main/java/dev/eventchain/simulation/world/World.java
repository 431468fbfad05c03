package dev.eventchain.simulation.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;

/**
 * The road with the ego and all actors on it, as boxes that move in the plane. Gaps are measured
 * along the road, from bumper to bumper. An impact of the ego stops simulated time.
 */
public final class World {

  /** Interval between two states in the trace, in ns. */
  public static final long TRACE_STEP = 10_000_000L;

  private record Pending(long effectiveAt, VehicleCommand command) {}

  private final Situation situation;
  private final Trace trace;
  private final Deque<Pending> pending = new ArrayDeque<>();
  private final Set<String> gone = new HashSet<>();
  private final Optional<Director> director;
  private List<Actor> actors;
  private HumanDriver driver;
  private EgoMotion ego;
  private long now;
  private boolean ended;

  /** Time for which the ego's speed is constant, in ns; 0 if it changes continuously. */
  private final long speedStep;

  /** Begin of the next such step, in ns. */
  private long nextStep;

  /** Times at which the driver lets go of the pedals and of the wheel, in ns. */
  private long pedalsReleased = Long.MAX_VALUE;

  private long wheelReleased = Long.MAX_VALUE;

  /** Time at which the ego stops by itself, in ns, since no command of a speed came. */
  private long halts = Long.MAX_VALUE;

  /** Approximate position of the ego along the road, in m: a bend may exceed a full circle. */
  private double travelled;

  public World(EgoVehicle vehicle, List<Actor> actors) {
    this(Situation.straight(vehicle, actors), new Trace());
  }

  /**
   * Creates a world.
   *
   * @param trace an empty trace for the recording
   */
  public World(Situation situation, Trace trace) {
    this.trace = trace;
    this.situation = situation;
    this.ego = new EgoMotion(situation.ego());
    this.director = situation.director().map(Director.Source::begin);
    this.actors = director.map(Director::actors).orElse(situation.actors());
    this.driver = situation.driver();
    this.speedStep = nanoseconds(situation.ego().speedStep());
    trace.situation(situation);
    trace.actors(actors);
    record();
  }

  /** Returns simulated time, in ns. */
  public long now() {
    return now;
  }

  /** Returns the motion of the ego; not to be modified. */
  public EgoMotion ego() {
    return ego;
  }

  /** Returns the ego's speed, in m/s; never negative. */
  public double egoSpeed() {
    return ego.speed();
  }

  /** Returns whether the ego neither drives nor turns on the spot. */
  public boolean egoRests() {
    return ego.speed() == 0.0 && ego.spin() == 0.0;
  }

  /**
   * Returns whether the ego hit an actor or a wall next to the road, or was hit, but not from
   * behind.
   */
  public boolean impacted() {
    return trace.impactSpeed().isPresent();
  }

  /** Returns whether the scenario is over before its time: by an impact, or as it says. */
  public boolean isOver() {
    return ended || impacted();
  }

  /**
   * Returns whether a maneuver has not begun, or may begin as long as the scenario has not ended.
   */
  public boolean waits() {
    return director.isPresent() || maneuversWait();
  }

  private boolean maneuversWait() {
    return driver.motion().waits() || actors.stream().anyMatch(Actor::waits);
  }

  /** Returns the trace up to now. */
  public Trace trace() {
    return trace;
  }

  public Road road() {
    return situation.road();
  }

  /** Returns all actors, including those that are gone. */
  public List<Actor> allActors() {
    return actors;
  }

  /** Returns all actors that are there, except those that drove into the ego's rear. */
  public List<Actor> actors() {
    double seconds = seconds(now);
    return gone.isEmpty() && director.isEmpty()
        ? actors
        : actors.stream()
            .filter(each -> !gone.contains(each.name()) && each.exists(seconds))
            .toList();
  }

  /** Returns the position of the ego's front bumper on the road. */
  public Road.Station station() {
    Road.Place front = ego.front();
    return road().station(front.x(), front.y(), travelled);
  }

  private double heading(Road.Station station) {
    return ego.front().heading() - road().heading(station.along());
  }

  /**
   * Accepts a command, which takes effect after the delay of the brake.
   *
   * @param time its publication time, in ns: not before now and not before the last one
   */
  public void command(long time, VehicleCommand command) {
    pending.add(new Pending(time + nanoseconds(situation.ego().brakeDelay()), command));
    trace.command(time, command);
  }

  /**
   * Lets the driver release the pedals and the wheel at some times, in ns, without a demand of the
   * software.
   */
  public void release(OptionalLong pedals, OptionalLong wheel) {
    pedalsReleased = pedals.orElse(Long.MAX_VALUE);
    wheelReleased = wheel.orElse(Long.MAX_VALUE);
  }

  /** Advances time, or stops at an impact or at the end of the scenario. */
  public void advanceTo(long until) {
    while (now < until && !isOver()) {
      long next = Math.min(until, (now / TRACE_STEP + 1) * TRACE_STEP);
      Pending following = pending.peek();
      if (following != null && following.effectiveAt() <= now) {
        follow(pending.remove().command());
        continue;
      }
      if (halts <= now) {
        ego.halt();
        halts = Long.MAX_VALUE;
      }
      ego.release(pedalsReleased <= now, wheelReleased <= now);
      if (following != null) {
        next = Math.min(next, following.effectiveAt());
      }
      next = Math.min(next, halts);
      next = pedalsReleased > now ? Math.min(next, pedalsReleased) : next;
      next = wheelReleased > now ? Math.min(next, wheelReleased) : next;
      advancePiece(speedStep > 0 ? step(next) : next);
    }
  }

  /**
   * Begins a step of the ego's speed where one is due; returns when the next one is, if earlier.
   */
  private long step(long next) {
    if (nextStep <= now) {
      ego.step();
      nextStep += speedStep;
    }
    return Math.min(next, nextStep);
  }

  private void follow(VehicleCommand command) {
    ego.follow(command, driver.scripted());
    long timeout = nanoseconds(situation.ego().commandTimeout());
    if (timeout > 0 && command.motor().filter(VehicleCommand.Motor::isRenewed).isPresent()) {
      halts = now + timeout;
    }
    trace.taken(now, !ego.held(), !ego.steered());
  }

  private void advancePiece(long until) {
    Movement movement = new Movement(ego.copy(), now, until, situation.road(), travelled);
    ego.advance(seconds(until - now));
    travelled += ego.velocity() * seconds(until - now);
    now = until;
    Optional<Contact> contact =
        actors().stream()
            .filter(actor -> actor.obstructs(ego.shape()))
            .flatMap(actor -> movement.contact(actor).stream())
            .min(Comparator.comparingLong(Contact::time));
    contact.filter(Contact::fromBehind).ifPresent(this::hitFromBehind);
    Optional<Contact> impact = contact.filter(each -> !each.fromBehind());
    if (impact.isPresent()) {
      end(movement, impact.get().time());
      trace.impact(impact.get().speed(), impact.get().words());
    } else if (road().isFurnished() && movement.leavesTheRoad(until)) {
      end(movement, movement.leaving());
      double turning = ego.spin() * ego.axleToBumper();
      trace.impact(StrictMath.hypot(ego.speed(), turning), "the ego left the road");
    }
    if (impacted() || now % TRACE_STEP == 0) {
      record();
    }
  }

  private void end(Movement movement, long time) {
    now = time;
    ego = movement.at(time);
  }

  /** Removes an actor that drove into the ego's rear, since the consequences are not simulated. */
  private void hitFromBehind(Contact contact) {
    gone.add(contact.other().name());
    trace.hitFromBehind(contact);
  }

  /** Updates the driver's demands until the next update. */
  private void letDrive() {
    if (ego.held()) {
      director.ifPresentOrElse(
          it -> ego.driveExactly(it.acceleration()),
          () -> ego.drive(driver.acceleration(seconds(now), ego.speed())));
    }
    if (ego.steered()) {
      director.ifPresentOrElse(it -> ego.steer(it.curvature()), this::keepLane);
    }
  }

  private void keepLane() {
    if (driver.steers(road())) {
      Road.Station station = station();
      // At the rear axle, which follows the bend, the heading of the road lags behind that at the
      // bumper.
      double bend = road().curvature(station.along());
      double steady = situation.ego().steadyHeading(bend, station.across());
      double heading = heading(station) - steady;
      ego.steer(driver.curvature(road(), station, heading, ego.speed(), seconds(now)));
    }
  }

  private void record() {
    begin();
    letDrive();
    trace.state(state());
  }

  /** Lets maneuvers begin, or the scenario end, where what they wait for has come. */
  private void begin() {
    director.filter(it -> now % TRACE_STEP == 0).ifPresent(this::continueWith);
    if (maneuversWait()) {
      Trace moment = moment();
      driver = driver.continued(now, moment);
      actors = actors.stream().map(actor -> actor.continued(now, moment)).toList();
      trace.actors(actors);
      trace.neverBegun(waiting());
    }
    ended |= situation.end().filter(condition -> condition.test(moment())).isPresent();
  }

  private void continueWith(Director other) {
    other.continueAt(
        (int) (now / TRACE_STEP),
        new Director.Ego(
            ego.front(),
            ego.velocity(),
            0.0 - ego.deceleration(),
            ego.yawRate(),
            !ego.held(),
            !ego.steered()));
    trace.neverBegun(other.neverBegun());
    trace.happened(other.happenings());
    ended |= other.ended();
  }

  /** Returns the maneuvers that have not begun, except for optional ones, in words. */
  private List<String> waiting() {
    List<String> waiting = new ArrayList<>(words("the driver", driver.motion().waiting()));
    actors.forEach(actor -> waiting.addAll(words(actor.name(), actor.waiting())));
    return waiting;
  }

  private static List<String> words(String who, List<Maneuver> waiting) {
    return waiting.stream()
        .filter(maneuver -> !maneuver.optional())
        .map(maneuver -> "that of " + who + " " + maneuver.start().words())
        .toList();
  }

  /** Returns the current state, with the last command, as a trace. */
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

  /** Returns the nearest actor that is in the ego's path and not behind it. */
  private Optional<Actor> nearest(Road.Station station) {
    double time = seconds(now);
    Actor nearest = null;
    for (Actor actor : actors()) {
      double gap = actor.rear(time) - station.along();
      boolean inPath =
          Math.abs(actor.across(time) - station.across())
              < situation.ego().shape().width() / 2 + actor.breadth(time);
      if (actor.obstructs(ego.shape())
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

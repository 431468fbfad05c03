package dev.eventchain.simulation.stage;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.openscenario.storyboard.StoryboardRun;
import dev.eventchain.openscenario.storyboard.tree.Change;
import dev.eventchain.openscenario.storyboard.world.ControlDomain;
import dev.eventchain.openscenario.storyboard.world.Entity;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.Progress;
import dev.eventchain.openscenario.storyboard.world.Visibility;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Director;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Shape;
import dev.eventchain.simulation.world.Track;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Plays a storyboard in the world. */
final class StoryboardDirector implements Director {

  /** The type of storyboard elements that formulas may ask for. */
  private static final String EVENT = "event";

  /** Distance from which on the ego is at another place, in m. */
  private static final double JUMP = 0.5;

  private static final double STEP = World.seconds(World.TRACE_STEP);

  private final StoryboardRun run;
  private final Frame frame;
  private final Entity ego;
  private final ScenarioDriver driver;
  private final Map<String, Track> tracks = new LinkedHashMap<>();
  private final Map<String, Actor> actors = new LinkedHashMap<>();
  private final List<Actor> all;
  private final Shape shape;
  private final Optional<Limit> limit;
  private final List<Happening> happenings = new ArrayList<>();
  private final Set<String> running = new HashSet<>();
  private double acceleration;
  private double curvature;
  private Pose planned;
  private int now;
  private int known;

  /**
   * The time at which a storyboard has to be at its end.
   *
   * @param moment the last one
   * @param words what has not happened then
   */
  record Limit(int moment, String words) {}

  /**
   * Begins a run.
   *
   * @param run at time 0
   * @param shape that of the ego, which a project may describe otherwise than the scenario
   * @param standing what stands at the road
   * @param limit empty if the run may end at any time
   */
  StoryboardDirector(
      StoryboardRun run,
      Frame frame,
      Road road,
      String ego,
      Shape shape,
      List<Actor> standing,
      Optional<Limit> limit) {
    this.run = run;
    this.frame = frame;
    this.limit = limit;
    this.shape = shape;
    Map<String, Entity> entities = run.entities().objects();
    this.ego = entities.get(ego);
    this.driver = new ScenarioDriver(frame, road, this.ego.box().front());
    for (Entity entity : entities.values()) {
      if (!entity.name().equals(ego) && entity.box().length() > 0.0) {
        Track track = new Track(road);
        tracks.put(entity.name(), track);
        actors.put(entity.name(), Cast.actor(entity, track));
      }
    }
    move(0);
    all = new ArrayList<>(actors.values());
    all.addAll(standing);
  }

  @Override
  public List<Actor> actors() {
    return List.copyOf(all);
  }

  /**
   * Actions that the storyboard cannot play are a problem of the scenario, which notices no fault
   * by it.
   */
  @Override
  public void continueAt(int moment, Ego seen) {
    try {
      play(moment, seen);
    } catch (DiagnosticException e) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, e.diagnostics());
    }
  }

  private void play(int moment, Ego seen) {
    Set<ControlDomain> taken = taken(seen);
    run.handOver(taken);
    if (moment > 0) {
      run.advance(
          STEP,
          taken.isEmpty() ? Optional.empty() : Optional.of(state(seen)),
          (one, other) -> touch(one, other, seen));
    }
    now = moment;
    move(moment);
    EntityState known = run.states().get(ego.name());
    if (moment > 0) {
      requireNoJump(known, taken.isEmpty() ? planned : state(seen).pose());
    }
    EntityState wanted = run.next(STEP).get(ego.name());
    planned = wanted.pose();
    acceleration = (wanted.speed() - seen.velocity()) / STEP;
    curvature =
        run.isOnLine() && seen.pedals()
            ? driver.curvature(seen, wanted, run.next(2 * STEP).get(ego.name()))
            : driver.curvatureOfLane(seen, known, wanted);
  }

  /** Returns what the software controls of the ego. */
  private static Set<ControlDomain> taken(Ego seen) {
    Set<ControlDomain> taken = EnumSet.noneOf(ControlDomain.class);
    if (seen.pedals()) {
      taken.add(ControlDomain.LONGITUDINAL);
    }
    if (seen.wheel()) {
      taken.add(ControlDomain.LATERAL);
    }
    return taken;
  }

  /** Refuses what moves the ego to another place at once, which no vehicle can follow. */
  private void requireNoJump(EntityState known, Pose expected) {
    if (StrictMath.hypot(known.pose().x() - expected.x(), known.pose().y() - expected.y()) > JUMP) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  StageRules.EGO_MOVED,
                  String.format(
                      Locale.ROOT,
                      "After %.2f s, the storyboard puts %s at another place.",
                      run.time(),
                      ego.name()),
                  ego.written().location())
              .withHint("Place it in Init: a vehicle under test moves as it can."));
    }
  }

  private void move(int moment) {
    Map<String, EntityState> states = run.states();
    Map<String, EntityState> next = run.next(STEP);
    tracks.forEach(
        (name, track) ->
            track.put(moment, moment(name, states.get(name)), moment(name, next.get(name))));
  }

  /** Returns an entity in the world; null if it is not there. */
  private Track.Moment moment(String name, EntityState state) {
    Entity entity = run.entities().objects().get(name);
    return state.exists() ? frame.moment(state, entity.box().x(), entity.box().y()) : null;
  }

  private EntityState state(Ego seen) {
    Pose front = frame.toMap(seen.front());
    Pose pose = front.moved(-ego.box().front(), -ego.box().y());
    double cos = StrictMath.cos(pose.heading());
    double sin = StrictMath.sin(pose.heading());
    return new EntityState(
        pose,
        seen.velocity(),
        seen.acceleration(),
        seen.velocity() * cos,
        seen.velocity() * sin,
        seen.yawRate(),
        Optional.empty(),
        Visibility.ALL,
        true);
  }

  /** Returns whether two entities touch at this moment, as they have moved. */
  private boolean touch(String one, String other, Ego seen) {
    Optional<Body> body = body(one, seen);
    return body.isPresent()
        && body(other, seen).filter(it -> body.get().separation(it) <= 0.0).isPresent();
  }

  /** Returns the body of an entity; empty if it is not there, or has none. */
  private Optional<Body> body(String name, Ego seen) {
    if (name.equals(ego.name())) {
      return Optional.of(shape.body(seen.front()));
    }
    double seconds = World.seconds((now + 1L) * World.TRACE_STEP);
    return Optional.ofNullable(actors.get(name))
        .filter(actor -> actor.exists(seconds))
        .map(actor -> actor.body(null, seconds));
  }

  @Override
  public double acceleration() {
    return acceleration;
  }

  @Override
  public double curvature() {
    return curvature;
  }

  /** An event that is skipped, or stopped while it waits, neither begins nor ends. */
  @Override
  public List<Happening> happenings() {
    List<Change> changes = run.changes();
    for (Change change : changes.subList(known, changes.size())) {
      boolean begins = change.transition() == Progress.Transition.START;
      boolean counts =
          change.type().equals(EVENT) && (begins ? running.add(change.path()) : isEnd(change));
      if (counts) {
        String name = change.path().substring(change.path().lastIndexOf('/') + 1);
        happenings.add(new Happening(name, begins, World.nanoseconds(change.time())));
      }
    }
    known = changes.size();
    return happenings;
  }

  private boolean isEnd(Change change) {
    return change.transition() != null && running.remove(change.path());
  }

  @Override
  public boolean ended() {
    return run.ended();
  }

  @Override
  public List<String> neverBegun() {
    return limit
        .filter(it -> now >= it.moment() && !run.ended())
        .map(it -> List.of(it.words()))
        .orElse(List.of());
  }
}

package dev.eventchain.openscenario.storyboard.scene;

import dev.eventchain.openscenario.storyboard.world.Angles;
import dev.eventchain.openscenario.storyboard.world.ControlDomain;
import dev.eventchain.openscenario.storyboard.world.Entity;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** An entity in motion. */
public final class Actor {

  /** Largest angle of the heading to the way while an entity moves across it. */
  private static final double MOST_ACROSS = Math.PI / 4;

  /** Distance from which on a place that is seen is another one than the expected one, in m. */
  private static final double SAME = 1e-6;

  private final Entity entity;
  private EntityState state = EntityState.ABSENT;
  private Odometer odometer = Odometer.START;
  private Longitudinal longitudinal = Longitudinal.KEEP;
  private Lateral lateral = StraightOn.STRAIGHT_ON;
  private Task longitudinalTask;
  private Task lateralTask;
  private final Set<ControlDomain> own = EnumSet.noneOf(ControlDomain.class);
  private List<RoadPoint> route = List.of();

  Actor(Entity entity) {
    this.entity = entity;
  }

  /** A step that is not made yet. */
  public record Next(
      EntityState state, Odometer odometer, Longitudinal.Step along, Lateral.Step across) {}

  public Entity entity() {
    return entity;
  }

  public EntityState state() {
    return state;
  }

  public Odometer odometer() {
    return odometer;
  }

  /** Returns the roads to take, in their order; empty without a route. */
  public List<RoadPoint> route() {
    return route;
  }

  public void route(List<RoadPoint> roads) {
    route = List.copyOf(roads);
  }

  /** Returns what decides the way. */
  public Lateral lateral() {
    return lateral;
  }

  /** Returns whether it decides a part of its motion itself, so that actions do not. */
  public boolean decides(ControlDomain domain) {
    return own.contains(domain);
  }

  /** Lets it decide parts of its motion itself from now on. */
  public void release(Set<ControlDomain> domains) {
    own.addAll(domains);
  }

  /** Lets it go on along a way, which no task decides. */
  public void follow(Lateral way) {
    lateral = way;
  }

  /**
   * Puts it somewhere at once; it goes on from there as it does of itself. One that is no more
   * there does nothing any more.
   */
  public void place(Scene scene, EntityState newState) {
    state = newState;
    odometer = odometer.at(state);
    if (!state.exists() && longitudinalTask != null) {
      longitudinalTask.override();
      free(scene, longitudinalTask);
    }
    if (lateralTask != null) {
      lateralTask.override();
      free(scene, lateralTask);
    }
    lateral = KeepLane.of(scene, state);
  }

  /** Gives it another speed at once, unless it decides that itself. */
  public void speed(double speed) {
    if (!decides(ControlDomain.LONGITUDINAL)) {
      state = state.withSpeed(entity.performance().limited(speed));
      odometer = odometer.at(state);
    }
  }

  /** Sets who sees it, or whether it is there. */
  public void show(EntityState newState) {
    state = newState;
  }

  /** Has a task decide the speed; what decided it before is over. */
  public void drive(Scene scene, Task task, Longitudinal control) {
    if (longitudinalTask != null && longitudinalTask != task) {
      Task before = longitudinalTask;
      before.override();
      free(scene, before);
    }
    longitudinalTask = task;
    longitudinal = control;
  }

  /** Has a task decide the way; what decided it before is over. */
  public void steer(Scene scene, Task task, Lateral control) {
    if (lateralTask != null && lateralTask != task) {
      Task before = lateralTask;
      before.override();
      free(scene, before);
    }
    lateralTask = task;
    lateral = control;
  }

  /** Ends what a task decides: the speed is kept, and the lane. */
  public void free(Scene scene, Task task) {
    if (longitudinalTask == task) {
      longitudinalTask = null;
      longitudinal = Longitudinal.KEEP;
    }
    if (lateralTask == task) {
      lateralTask = null;
      lateral = lateral.rest(scene, state);
    }
  }

  /** Returns where it is after a time, if nothing is decided anew. */
  public Next next(Scene scene, double dt) {
    Longitudinal.Step planned = longitudinal.step(scene, this, dt);
    Longitudinal.Step along =
        decides(ControlDomain.LONGITUDINAL)
            ? new Longitudinal.Step(
                state.speed() * dt, state.speed(), 0, planned.next(), planned.done())
            : planned;
    Lateral.Step across = lateral.step(scene, this, along, dt);
    EntityState after = after(along, across, dt);
    return new Next(
        after, odometer.after(along.distance(), after, across.atEnd(), dt), along, across);
  }

  private EntityState after(Longitudinal.Step along, Lateral.Step across, double dt) {
    double speed = across.atEnd() ? 0 : along.speed();
    double turned = 0;
    if (across.across() != 0) {
      double angle = StrictMath.atan2(across.across(), Math.abs(speed));
      turned = Math.max(-MOST_ACROSS, Math.min(MOST_ACROSS, angle)) * (speed < 0 ? -1 : 1);
    }
    Pose pose = across.pose().withHeading(across.pose().heading() + turned);
    double cos = StrictMath.cos(across.course());
    double sin = StrictMath.sin(across.course());
    return new EntityState(
        pose,
        speed,
        across.atEnd() ? 0 : along.acceleration(),
        speed * cos - across.across() * sin,
        speed * sin + across.across() * cos,
        Angles.normalized(pose.heading() - state.pose().heading()) / dt,
        across.road(),
        state.visibility(),
        true);
  }

  /** Makes a step, and says so to the tasks whose aim it reached. */
  void make(Scene scene, Next next, double dt) {
    state = next.state();
    odometer = next.odometer();
    longitudinal = next.along().next();
    lateral = next.across().next();
    settle(scene, next);
  }

  private void settle(Scene scene, Next next) {
    Task along = longitudinalTask;
    Task across = lateralTask;
    if (along != null && next.along().done()) {
      along.finish();
      free(scene, along);
    }
    if (across != null && next.across().done()) {
      across.finish();
      free(scene, across);
    }
  }

  /** Makes a step that another one decided, and says so to the tasks whose aim it reached. */
  void see(Scene scene, Next expected, EntityState seen, double dt) {
    Optional<LanePoint> road =
        seen.pose().distance(expected.state().pose()) < SAME
            ? expected.state().road()
            : scene.roads().find(seen.pose());
    double way = state.exists() ? state.pose().distance(seen.pose()) : 0;
    state = seen.withRoad(road);
    odometer = odometer.after(way, state, expected.across().atEnd(), dt);
    longitudinal = expected.along().next();
    Lateral next = expected.across().next();
    boolean same = seen.pose().distance(expected.state().pose()) < SAME;
    lateral = same ? next : next.from(scene, state);
    settle(scene, expected);
  }
}

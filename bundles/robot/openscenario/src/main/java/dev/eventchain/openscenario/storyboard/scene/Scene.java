package dev.eventchain.openscenario.storyboard.scene;

import dev.eventchain.openscenario.storyboard.world.Collisions;
import dev.eventchain.openscenario.storyboard.world.Entities;
import dev.eventchain.openscenario.storyboard.world.Entity;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Progress;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RouteSides;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** All that conditions look at and actions change. */
public final class Scene {

  private static final double NANOS = 1e9;

  private final Entities entities;
  private final RoadMap roads;
  private final Map<String, Actor> actors = new LinkedHashMap<>();
  private final Values parameters = new Values();
  private final Values variables = new Values();
  private final Signals signals;
  private final RouteSides routeSides;
  private final Surroundings surroundings = new Surroundings();
  private final Map<String, Progress> progress = new HashMap<>();
  private Collisions collisions = Collisions.NONE;
  private long nanos;
  private long steps;

  /** Creates a scene at time 0 in which no entity is yet. */
  public Scene(Entities entities, RoadMap roads, Signals signals, RouteSides routeSides) {
    this.routeSides = routeSides;
    this.entities = entities;
    this.roads = roads;
    this.signals = signals;
    for (Entity each : entities.objects().values()) {
      actors.put(each.name(), new Actor(each));
    }
  }

  public Entities entities() {
    return entities;
  }

  public RoadMap roads() {
    return roads;
  }

  /** Returns which side positions on routes mean. */
  public RouteSides routeSides() {
    return routeSides;
  }

  /** Returns the simulated time in s. */
  public double time() {
    return nanos / NANOS;
  }

  /** Returns the simulated time in ns. */
  public long nanos() {
    return nanos;
  }

  /** Returns the number of steps so far. */
  public long step() {
    return steps;
  }

  public Actor actor(String name) {
    return actors.get(name);
  }

  public Collection<Actor> actors() {
    return actors.values();
  }

  /** Returns the state of an entity. */
  public EntityState state(String name) {
    return actors.get(name).state();
  }

  public Values parameters() {
    return parameters;
  }

  public Values variables() {
    return variables;
  }

  public Signals signals() {
    return signals;
  }

  public Surroundings surroundings() {
    return surroundings;
  }

  public Collisions collisions() {
    return collisions;
  }

  /** Returns the state of an element by its path. */
  public Progress progress(String path) {
    return progress.getOrDefault(path, Progress.START);
  }

  /** Sets the state of an element. */
  public void progress(String path, Progress now) {
    progress.put(path, now);
  }

  /** Returns where the entities are after a time if nothing is decided anew, in their order. */
  public Map<String, Actor.Next> next(double dt) {
    Map<String, Actor.Next> next = new LinkedHashMap<>();
    for (Actor each : actors.values()) {
      if (each.state().exists()) {
        next.put(each.entity().name(), each.next(this, dt));
      }
    }
    return next;
  }

  /**
   * Moves all entities.
   *
   * @param seen the states of those that something else moved
   */
  public void advance(double dt, Map<String, EntityState> seen, Collisions contacts) {
    Map<String, Actor.Next> next = next(dt);
    nanos += Math.round(dt * NANOS);
    steps++;
    collisions = contacts;
    next.forEach(
        (name, step) -> {
          Optional<EntityState> other = Optional.ofNullable(seen.get(name));
          if (other.isPresent()) {
            actor(name).see(this, step, other.get(), dt);
          } else {
            actor(name).make(this, step, dt);
          }
        });
    surroundings.advance(dt);
  }
}

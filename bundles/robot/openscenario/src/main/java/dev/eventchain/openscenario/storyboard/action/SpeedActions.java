package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import java.util.Optional;

/** Changes of speed. */
final class SpeedActions {

  private SpeedActions() {}

  static PrivateAction read(ScenarioElement action) {
    Dynamics dynamics = Dynamics.of(action.required("SpeedActionDynamics"));
    ScenarioElement target = action.required("SpeedActionTarget").choice();
    SpeedTarget speed = SpeedTarget.of(target);
    return target.flag("continuous", false)
        ? (scene, actor) -> follow(scene, actor, dynamics, speed)
        : (scene, actor) -> change(scene, actor, dynamics, speed.in(scene));
  }

  private static Optional<Task> change(Scene scene, Actor actor, Dynamics dynamics, double target) {
    double from = actor.state().speed();
    double to = actor.entity().performance().limited(target);
    double duration = duration(actor, dynamics, from, to);
    Task task = new Task(actor.entity().name());
    if (dynamics.atOnce() || !(duration > 0)) {
      actor.drive(scene, task, Longitudinal.KEEP);
      actor.free(scene, task);
      actor.speed(to);
      return Optional.empty();
    }
    actor.drive(
        scene, task, new SpeedChange(new Transition(dynamics.shape(), from, to, duration), 0));
    return Optional.of(task);
  }

  /**
   * Returns how long a change takes. A distance is that which is driven meanwhile; since all shapes
   * have the mean of their ends, it is the same for all.
   */
  private static double duration(Actor actor, Dynamics dynamics, double from, double to) {
    double duration;
    if (dynamics.dimension().equals("distance")) {
      double mean = Math.abs(from + to) / 2;
      duration = mean > 0 ? dynamics.value() / mean : 0;
    } else {
      duration = dynamics.duration(to - from);
    }
    if (!dynamics.within()) {
      return duration;
    }
    double most = actor.entity().performance().rate(from, to);
    return Math.max(duration, dynamics.shape().steepest() * Math.abs(to - from) / most);
  }

  /** Follows another one's speed, which never ends. */
  private static Optional<Task> follow(
      Scene scene, Actor actor, Dynamics dynamics, SpeedTarget target) {
    Task task = new Task(actor.entity().name());
    double from = actor.state().speed();
    double duration = duration(actor, dynamics, from, target.in(scene));
    boolean atOnce = dynamics.atOnce() || !(duration > 0);
    if (atOnce) {
      actor.speed(target.in(scene));
    }
    double rate =
        dynamics.shape() != Shape.STEP && dynamics.dimension().equals("rate")
            ? dynamics.value()
            : Double.POSITIVE_INFINITY;
    actor.drive(
        scene,
        task,
        new SpeedFollowing(target, dynamics.shape(), rate, from, atOnce ? 0 : duration, 0));
    return Optional.of(task);
  }
}

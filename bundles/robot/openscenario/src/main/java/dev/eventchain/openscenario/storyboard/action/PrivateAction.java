package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** An action of one entity. */
@FunctionalInterface
interface PrivateAction {

  /** One that has no effect. */
  PrivateAction NONE = (scene, actor) -> Optional.empty();

  /** Starts it for an entity; returns what that has to do, or nothing if it is done at once. */
  Optional<Task> start(Scene scene, Actor actor);

  /** Returns the action that each of its actors does. */
  default Action ofEach() {
    return (scene, actors) -> {
      List<Task> tasks = new ArrayList<>();
      for (String each : actors) {
        start(scene, scene.actor(each)).ifPresent(tasks::add);
      }
      return tasks;
    };
  }
}

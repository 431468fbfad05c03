package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** An action of one entity. */
@FunctionalInterface
interface PrivateAction extends Action {

  /** Starts it for an entity; returns what that has to do, or nothing if it is done at once. */
  Optional<Task> start(Scene scene, Actor actor);

  @Override
  default List<Task> start(Scene scene, List<String> actors) {
    List<Task> tasks = new ArrayList<>();
    for (String each : actors) {
      start(scene, scene.actor(each)).ifPresent(tasks::add);
    }
    return tasks;
  }
}

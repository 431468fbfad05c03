package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import java.util.List;

/** An action. */
@FunctionalInterface
public interface Action {

  /** An action that has no effect. */
  Action NONE = (scene, actors) -> List.of();

  /**
   * Starts it.
   *
   * @param actors the entities of private actions
   * @return what has to be done before the action ends; empty if it ends at once
   */
  List<Task> start(Scene scene, List<String> actors);
}

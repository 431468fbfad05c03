package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.storyboard.action.Action;
import dev.eventchain.openscenario.storyboard.condition.Outcome;
import dev.eventchain.openscenario.storyboard.scene.Task;
import dev.eventchain.openscenario.storyboard.world.Progress.State;
import dev.eventchain.openscenario.storyboard.world.Progress.Transition;
import java.util.List;
import java.util.function.Function;

/** An action. */
final class ActionNode extends Node {

  private final Action action;
  private final Function<Outcome, List<String>> actors;
  private List<Task> tasks = List.of();

  ActionNode(String path, Log log, Action action, Function<Outcome, List<String>> actors) {
    super(path, "action", log);
    this.action = action;
    this.actors = actors;
  }

  @Override
  List<Node> children() {
    return List.of();
  }

  @Override
  void enter(Outcome cause) {
    make(Transition.START, State.RUNNING);
    tasks = action.start(scene(), actors.apply(cause));
  }

  /** An action that lost one of its entities to another action ends for all of them. */
  @Override
  boolean update() {
    if (state() != State.RUNNING) {
      return false;
    }
    if (tasks.stream().anyMatch(Task::overridden)) {
      stop();
      return true;
    }
    if (tasks.stream().allMatch(Task::done)) {
      make(Transition.END, State.COMPLETE);
      return true;
    }
    return false;
  }

  @Override
  void stop() {
    if (state() == State.RUNNING) {
      for (Task each : tasks) {
        scene().actor(each.entity()).free(scene(), each);
      }
    }
    super.stop();
  }
}

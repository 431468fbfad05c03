package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.storyboard.condition.Outcome;
import dev.eventchain.openscenario.storyboard.condition.Trigger;
import dev.eventchain.openscenario.storyboard.world.Progress.State;
import dev.eventchain.openscenario.storyboard.world.Progress.Transition;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** An event. It starts at most once in a step, so that events cannot start each other forever. */
final class Event extends Node {

  /** Effect of an event on the others of its maneuver. */
  enum Priority {
    OVERRIDE,
    PARALLEL,
    SKIP
  }

  private final Branch maneuver;
  private final Priority priority;
  private final int most;
  private final Optional<Trigger> trigger;
  private final List<ActionNode> actions = new ArrayList<>();
  private Outcome cause;
  private int executions;
  private long triggered = -1;

  Event(
      String path,
      Log log,
      Branch maneuver,
      Priority priority,
      int most,
      Optional<Trigger> trigger) {
    super(path, "event", log);
    this.maneuver = maneuver;
    this.priority = priority;
    this.most = most;
    this.trigger = trigger;
  }

  void add(ActionNode action) {
    actions.add(action);
  }

  @Override
  List<ActionNode> children() {
    return actions;
  }

  @Override
  void enter(Outcome by) {
    cause = by;
    executions = 0;
    trigger.ifPresent(Trigger::reset);
    standBy();
  }

  @Override
  boolean update() {
    if (state() == State.RUNNING) {
      // So that its conditions know what they were, should it wait for them again.
      trigger.ifPresent(each -> each.in(scene()));
      return run();
    }
    if (state() != State.STANDBY || triggered == scene().step()) {
      return false;
    }
    // Without a trigger of its own it has that of the act.
    if (!trigger.map(each -> each.in(scene())).orElse(cause).holds()) {
      return false;
    }
    triggered = scene().step();
    executions++;
    if (priority == Priority.SKIP && othersRun()) {
      make(Transition.SKIP, executions < most ? State.STANDBY : State.COMPLETE);
    } else {
      start();
    }
    return true;
  }

  private boolean othersRun() {
    return maneuver.children().stream()
        .anyMatch(each -> each != this && each.state() == State.RUNNING);
  }

  /** Starts its actions, whose actors are those that triggered the act, whatever triggered it. */
  private void start() {
    if (priority == Priority.OVERRIDE) {
      for (Node each : maneuver.children()) {
        if (each != this && each.state() == State.RUNNING) {
          each.stop();
        }
      }
    }
    make(Transition.START, State.RUNNING);
    actions.forEach(each -> each.enter(cause));
  }

  private boolean run() {
    boolean changed = updateChildren();
    if (!allComplete()) {
      return changed;
    }
    make(Transition.END, executions < most ? State.STANDBY : State.COMPLETE);
    return true;
  }
}

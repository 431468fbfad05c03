package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.storyboard.condition.Outcome;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.Progress;
import dev.eventchain.openscenario.storyboard.world.Progress.State;
import dev.eventchain.openscenario.storyboard.world.Progress.Transition;
import java.util.List;

/** An element of a storyboard as it runs. */
abstract class Node {

  private final String path;
  private final String type;
  private final Log log;

  Node(String path, String type, Log log) {
    this.path = path;
    this.type = type;
    this.log = log;
  }

  Scene scene() {
    return log.scene();
  }

  State state() {
    return scene().progress(path).state();
  }

  boolean isComplete() {
    return state() == State.COMPLETE;
  }

  void make(Transition transition, State state) {
    Progress after = scene().progress(path).after(transition, state, scene().step());
    log.add(path, type, transition, after);
  }

  /** Waits for a trigger; the transition that ended an execution stays one of its step. */
  void standBy() {
    log.add(path, type, null, scene().progress(path).waiting());
  }

  abstract List<? extends Node> children();

  /**
   * Becomes standby if it has a start trigger of its own, and starts otherwise.
   *
   * @param cause what started the enclosing act
   */
  abstract void enter(Outcome cause);

  /** Looks for what changes now; returns whether something did. */
  abstract boolean update();

  /** Ends it and all in it before their aims are reached. */
  void stop() {
    if (state() == State.STANDBY || state() == State.RUNNING) {
      children().forEach(Node::stop);
      make(Transition.STOP, State.COMPLETE);
    }
  }

  /** Updates the children; returns whether something changed. */
  boolean updateChildren() {
    boolean changed = false;
    for (Node each : children()) {
      changed |= each.update();
    }
    return changed;
  }

  boolean allComplete() {
    return children().stream().allMatch(Node::isComplete);
  }
}

package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.storyboard.condition.Outcome;
import dev.eventchain.openscenario.storyboard.world.Progress.State;
import dev.eventchain.openscenario.storyboard.world.Progress.Transition;
import java.util.ArrayList;
import java.util.List;

/** A story or a maneuver, which runs what is in it until all of that is complete. */
class Branch extends Node {

  private final List<Node> children = new ArrayList<>();

  Branch(String path, String type, Log log) {
    super(path, type, log);
  }

  void add(Node child) {
    children.add(child);
  }

  @Override
  List<Node> children() {
    return children;
  }

  @Override
  void enter(Outcome cause) {
    make(Transition.START, State.RUNNING);
    children.forEach(each -> each.enter(cause));
  }

  @Override
  boolean update() {
    if (state() != State.RUNNING) {
      return false;
    }
    boolean changed = updateChildren();
    if (allComplete()) {
      end();
      return true;
    }
    return changed;
  }

  void end() {
    make(Transition.END, State.COMPLETE);
  }
}

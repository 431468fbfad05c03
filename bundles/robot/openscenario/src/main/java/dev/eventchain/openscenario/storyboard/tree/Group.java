package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.storyboard.condition.Outcome;
import dev.eventchain.openscenario.storyboard.world.Progress.State;
import dev.eventchain.openscenario.storyboard.world.Progress.Transition;

/** A maneuver group. Another execution of it begins in the step after the end of the last one. */
final class Group extends Branch {

  private final int most;
  private int executions;
  private Outcome cause;

  Group(String path, Log log, int most) {
    super(path, "maneuverGroup", log);
    this.most = most;
  }

  @Override
  void enter(Outcome by) {
    cause = by;
    executions++;
    super.enter(by);
  }

  @Override
  boolean update() {
    if (state() == State.STANDBY && !madeNow(Transition.END)) {
      enter(cause);
      return true;
    }
    return super.update();
  }

  @Override
  void end() {
    make(Transition.END, executions < most ? State.STANDBY : State.COMPLETE);
  }
}

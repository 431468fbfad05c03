package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.storyboard.condition.Outcome;
import dev.eventchain.openscenario.storyboard.world.Progress.State;
import dev.eventchain.openscenario.storyboard.world.Progress.Transition;

/**
 * A maneuver group. Another execution of it begins when the last one ends, or in the next step if
 * that took no time.
 */
final class Group extends Branch {

  private final int most;
  private int executions;
  private long began;
  private Outcome cause;

  Group(String path, Log log, int most) {
    super(path, "maneuverGroup", log);
    this.most = most;
  }

  @Override
  void enter(Outcome by) {
    cause = by;
    executions++;
    began = scene().step();
    super.enter(by);
  }

  @Override
  boolean update() {
    if (state() == State.STANDBY && began < scene().step()) {
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

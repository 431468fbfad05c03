package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.storyboard.condition.Outcome;
import dev.eventchain.openscenario.storyboard.condition.Trigger;
import dev.eventchain.openscenario.storyboard.world.Progress.State;
import java.util.Optional;

/** An act. */
final class Act extends Branch {

  private final Optional<Trigger> start;
  private final Optional<Trigger> stop;

  Act(String path, Log log, Optional<Trigger> start, Optional<Trigger> stop) {
    super(path, "act", log);
    this.start = start;
    this.stop = stop;
  }

  @Override
  void enter(Outcome cause) {
    if (start.isPresent()) {
      standBy();
    } else {
      super.enter(cause);
    }
  }

  @Override
  boolean update() {
    if (state() != State.STANDBY && state() != State.RUNNING) {
      return false;
    }
    if (stop.isPresent() && stop.get().in(scene()).holds()) {
      stop();
      return true;
    }
    if (state() == State.RUNNING) {
      return super.update();
    }
    Outcome outcome = start.orElseThrow().in(scene());
    if (outcome.holds()) {
      super.enter(outcome);
    }
    return outcome.holds();
  }
}

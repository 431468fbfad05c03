package dev.eventchain.openscenario.storyboard.world;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;

/**
 * The state of an element of the storyboard.
 *
 * @param state where it is in its life
 * @param transitions those of the last step in which there were some
 * @param step that step
 */
public record Progress(State state, Set<Transition> transitions, long step) {

  /** That of an element which is not reached yet. */
  public static final Progress START = new Progress(State.NONE, Set.of(), -1);

  /** States, with {@code NONE} before the enclosing element runs. */
  public enum State {
    NONE,
    STANDBY,
    RUNNING,
    COMPLETE
  }

  /** Transitions between states. */
  public enum Transition {
    START,
    END,
    STOP,
    SKIP
  }

  /** Returns it after a transition; an element may make several in a step. */
  public Progress after(Transition transition, State newState, long now) {
    Set<Transition> all = EnumSet.of(transition);
    if (step == now) {
      all.addAll(transitions);
    }
    return new Progress(newState, Collections.unmodifiableSet(all), now);
  }

  /** Returns it while it waits for a trigger. */
  public Progress waiting() {
    return new Progress(State.STANDBY, transitions, step);
  }

  /** Returns whether a transition is one of a step. */
  public boolean is(Transition asked, long now) {
    return step == now && transitions.contains(asked);
  }
}

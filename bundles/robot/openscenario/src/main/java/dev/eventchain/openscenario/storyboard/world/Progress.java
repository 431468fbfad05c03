package dev.eventchain.openscenario.storyboard.world;

/**
 * The state of an element of the storyboard.
 *
 * @param state where it is in its life
 * @param transition the last one; null before the first
 * @param step the step in which that was
 */
public record Progress(State state, Transition transition, long step) {

  /** That of an element which is not reached yet. */
  public static final Progress START = new Progress(State.NONE, null, -1);

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

  /** Returns whether a transition is that of a step. */
  public boolean is(Transition asked, long now) {
    return transition == asked && step == now;
  }
}

package dev.eventchain.simulation.world;

import java.util.function.Predicate;

/**
 * A change of a script that does not begin at a fixed time: it begins once the one before it has
 * begun and its own start has come.
 *
 * @param optional true if a run may end without it
 */
public record Maneuver(Start start, Change change, boolean optional) {

  /** Trigger of the maneuver. */
  public sealed interface Start permits After, When {

    /** Returns it in words, such as "when gap < 30 m". */
    String words();
  }

  /** A time in ns after the begin of the maneuver before it, or after the start of the scenario. */
  public record After(long time) implements Start {

    @Override
    public String words() {
      return World.seconds(time) + " s after the one before it";
    }
  }

  /**
   * A condition of the world.
   *
   * @param condition is true of the trace of a moment
   */
  public record When(String text, Predicate<Trace> condition) implements Start {

    @Override
    public String words() {
      return "when " + text;
    }
  }

  /** Quantity that changes: the speed or the offset. */
  public sealed interface Change permits SpeedProfile.Change, LateralProfile.Change {}
}

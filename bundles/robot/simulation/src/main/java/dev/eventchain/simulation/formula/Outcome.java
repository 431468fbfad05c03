package dev.eventchain.simulation.formula;

import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Outcome of a judgement in a scenario.
 *
 * @param tested true if its premise came true; if not, it neither holds nor fails
 * @param passed true if it was tested and holds
 * @param detail the measured figures
 * @param margin the distance from the opposite verdict; empty if it has no size
 * @param decided the time of what decides it, in s since the start; empty if no single moment does
 * @param otherwise the times next to it at which that is the other way round, in s: at most one
 *     before and one after
 * @param lack why it was not tested
 * @param missing the topics without a current message, because of which it was not tested
 */
public record Outcome(
    boolean tested,
    boolean passed,
    String detail,
    Optional<Margin> margin,
    OptionalDouble decided,
    List<Double> otherwise,
    Lack lack,
    List<String> missing) {

  /** A reason why a criterion is not tested. */
  public enum Lack {
    /** It is tested. */
    NONE,
    /** Its premise never came true. */
    PREMISE,
    /** It is about what is ahead, and nothing was. */
    NOTHING_AHEAD,
    /** The run ended before its time. */
    TIME,
    /** Something that it reads had no value. */
    VALUE
  }

  /** Copies the lists. */
  public Outcome {
    otherwise = List.copyOf(otherwise);
    missing = List.copyOf(missing);
  }

  /** Creates an outcome that its margin decides, if it has one. */
  public Outcome(boolean tested, boolean passed, String detail, Optional<Margin> margin) {
    this(
        tested,
        passed,
        detail,
        margin,
        margin.stream().mapToDouble(Margin::time).findFirst(),
        List.of(),
        tested ? Lack.NONE : Lack.PREMISE,
        List.of());
  }

  public Outcome(boolean passed, String detail) {
    this(true, passed, detail, Optional.empty());
  }

  /** Creates an outcome without a size. */
  public Outcome(boolean passed, String detail, double decided) {
    this(
        true,
        passed,
        detail,
        Optional.empty(),
        OptionalDouble.of(decided),
        List.of(),
        Lack.NONE,
        List.of());
  }

  public Outcome(boolean passed, String detail, Margin margin) {
    this(true, passed, detail, Optional.of(margin));
  }

  /** Returns a copy with the times at which what decides it is the other way round, in s. */
  Outcome withOtherwise(List<Double> times) {
    return new Outcome(tested, passed, detail, margin, decided, times, lack, missing);
  }

  /** Returns whether it was tested and does not hold. */
  public boolean failed() {
    return tested && !passed;
  }

  /** Returns whether a run did not decide it, since it ended too early. */
  public boolean undecided() {
    return lack == Lack.TIME;
  }

  /** Returns the outcome of a criterion that a run did not decide, since it ended too early. */
  public static Outcome undecided(String why) {
    return untested(why, Lack.TIME, List.of());
  }

  /** Returns the outcome of a criterion about what is ahead, where nothing was. */
  public static Outcome nothingAhead() {
    return untested("nothing ahead", Lack.NOTHING_AHEAD, List.of());
  }

  /** Returns the outcome of a criterion that read something without a value. */
  static Outcome valueless(String why, List<String> missing) {
    return untested(why, Lack.VALUE, missing);
  }

  /** Returns the outcome of a criterion whose premise never came true. */
  public static Outcome untested(String why) {
    return untested(why, Lack.PREMISE, List.of());
  }

  private static Outcome untested(String why, Lack lack, List<String> missing) {
    return new Outcome(
        false, false, why, Optional.empty(), OptionalDouble.empty(), List.of(), lack, missing);
  }
}

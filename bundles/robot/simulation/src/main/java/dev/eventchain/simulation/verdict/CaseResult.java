package dev.eventchain.simulation.verdict;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Result of one case of a campaign.
 *
 * @param reason why it is not passed, in words; empty if it is
 * @param criteria in the order of the scenario
 * @param impactSpeed in m/s; empty without an impact
 * @param end simulated time, in s
 * @param nothingAhead whether it is passed, and 'no impact' holds since nothing was ahead: that may
 *     say nothing about the software
 */
public record CaseResult(
    Label label,
    String reason,
    List<CriterionMargin> criteria,
    OptionalDouble impactSpeed,
    double end,
    boolean nothingAhead) {

  /** The outcome in a word. */
  public enum Label {
    PASSED,
    FAILED,
    /** No criterion failed, and some could not be judged. */
    UNTESTED,
    /** The software could not be driven to the end. */
    ERROR
  }

  /**
   * The outcome of a criterion.
   *
   * @param margin positive if it holds, negative if it does not; empty if it has no size
   * @param unit of the margin; empty if there is none
   */
  public record CriterionMargin(String name, Label label, OptionalDouble margin, String unit) {}

  /** Creates the result of a case in which something was ahead, or no criterion is about that. */
  public CaseResult(
      Label label,
      String reason,
      List<CriterionMargin> criteria,
      OptionalDouble impactSpeed,
      double end) {
    this(label, reason, criteria, impactSpeed, end, false);
  }

  public CaseResult {
    criteria = List.copyOf(criteria);
  }

  /** Returns the result of a case that ended with an error. */
  public static CaseResult error(String reason) {
    return new CaseResult(Label.ERROR, reason, List.of(), OptionalDouble.empty(), 0.0);
  }
}

package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonValue;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * The outcome of a requirement.
 *
 * @param text the SHA-256 of the text that it is about, in which only white space does not count
 * @param strength the strength of its evidence, if it was measured
 */
public record RequirementOutcome(
    String id, Outcome outcome, String text, Optional<Strength> strength) {

  /**
   * The standard faults of its components that its criteria notice.
   *
   * @param noticed the number of noticed faults
   * @param faults the number of all that were driven and changed something
   * @param sampleOf the number of all that may change something, if not all were driven
   * @param bound what counts for the part that the project asks for; empty if it asks for none
   * @param unnoticed those that were driven and not noticed
   */
  public record Strength(
      int noticed,
      int faults,
      OptionalLong sampleOf,
      Optional<Bound> bound,
      List<Unnoticed> unnoticed) {

    /** Copies the list. */
    public Strength {
      unnoticed = List.copyOf(unnoticed);
    }
  }

  /**
   * The faults that are compared with the part that the project asks for.
   *
   * @param minimumPercent the least part, in percent
   * @param components the components whose faults count, in place of all that satisfy the
   *     requirement
   * @param noticed the number of noticed faults of these
   * @param faults the number of all faults of these that were driven and count; 0 if none does
   * @param sampleOf the number of all that may count, if not all were driven
   */
  public record Bound(
      double minimumPercent,
      List<String> components,
      int noticed,
      int faults,
      OptionalLong sampleOf) {

    /** Copies the list. */
    public Bound {
      components = List.copyOf(components);
    }
  }

  /**
   * A fault that was not noticed.
   *
   * @param nearest the criterion that came nearest; empty if none could be judged
   */
  public record Unnoticed(String fault, Optional<Nearest> nearest) {}

  /** A criterion that came near to noticing a fault, with its margin if that has a size. */
  public record Nearest(String scenario, String criterion, Optional<Criterion.Margin> margin) {}

  /** The possible outcomes. */
  public enum Outcome {
    /** It has at least one criterion, and all of them hold; so do its constraints, if any. */
    PROVED,
    /** One of its criteria failed, or one of its constraints is violated. */
    VIOLATED,
    /** It has no criterion, or one of its criteria or constraints could not be judged. */
    NOT_TESTED;

    /** Returns the text for people, which is also the JSON. */
    @JsonValue
    public String words() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }
}

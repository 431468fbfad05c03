package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A criterion of a scenario or a fault, and its outcome.
 *
 * @param text the requirement, in words
 * @param tested true if its premise came true
 * @param passed true if it was tested and holds
 * @param measured the measured figures, in words
 * @param margin the distance from the opposite verdict; empty if it has no size
 * @param judges the words of requirements that it judges
 * @param limits the numbers that signals are compared with
 * @param requirements ids of the requirements that it tests; empty if these are its scenario's
 * @param consequence true if it is a consequence of what ended the run, which another finding is
 *     about; otherwise empty
 */
public record Criterion(
    String text,
    boolean tested,
    boolean passed,
    String measured,
    Optional<Margin> margin,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Judged> judges,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Limit> limits,
    Optional<List<String>> requirements,
    Optional<Boolean> consequence) {

  /**
   * Distance of a criterion from the opposite verdict, negative if it does not hold.
   *
   * @param value in the unit; empty if it is infinite
   * @param time the time of the margin, in s since the start
   */
  public record Margin(OptionalDouble value, String unit, double time) {}

  /** A number, in the signal's unit, with which a criterion compares a signal. */
  public record Limit(String signal, double value) {}

  /** Words of a requirement. */
  public record Judged(String requirement, String words) {}

  /** Copies the lists, which JSON omits where they are empty. */
  public Criterion {
    judges = judges == null ? List.of() : List.copyOf(judges);
    limits = limits == null ? List.of() : List.copyOf(limits);
  }
}

package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonValue;
import java.util.Locale;

/**
 * The outcome of a requirement.
 *
 * @param text the SHA-256 of the text that it is about, in which only white space does not count
 */
public record RequirementOutcome(String id, Outcome outcome, String text) {

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

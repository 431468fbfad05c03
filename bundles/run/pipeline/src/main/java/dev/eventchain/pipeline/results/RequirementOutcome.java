package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonValue;
import java.util.Locale;

/** The outcome of a requirement. */
public record RequirementOutcome(String id, Outcome outcome) {

  /** The possible outcomes. */
  public enum Outcome {
    /** At least one scenario names it and all of them passed; so did its constraints, if any. */
    PROVED,
    /** A scenario that names it failed, or one of its constraints is violated. */
    VIOLATED,
    /** No scenario names it, or a scenario or constraint that names it could not be judged. */
    NOT_TESTED;

    /** Returns the text for people, which is also the JSON. */
    @JsonValue
    public String words() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }
}

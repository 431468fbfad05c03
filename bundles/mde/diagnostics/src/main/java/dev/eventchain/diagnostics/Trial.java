package dev.eventchain.diagnostics;

import java.util.List;
import java.util.Objects;

/**
 * A test that a command made of the software, with its outcome.
 *
 * @param name unique among those of its kind
 * @param text what was measured or is missing, in words; may be empty
 * @param seconds the simulated time that it took, in s: equal for equal inputs
 * @param findings those findings of the command that are about it
 */
public record Trial(
    Kind kind,
    String name,
    Outcome outcome,
    String text,
    double seconds,
    List<Diagnostic> findings) {

  /** What was tested. */
  public enum Kind {
    /** The software in a situation. */
    SCENARIO("scenarios"),
    /** One expectation of a scenario. */
    CRITERION("criteria"),
    /** A written requirement, by all that names it. */
    REQUIREMENT("requirements"),
    /** The software in a situation in which something breaks. */
    FAULT("faults"),
    /** The software in one of many situations that differ in numbers only. */
    CASE("cases");

    private final String title;

    Kind(String title) {
      this.title = title;
    }

    /** Returns the name of all tests of this kind. */
    String title() {
      return title;
    }
  }

  /** Possible outcomes. */
  public enum Outcome {
    PASSED,
    /** It did not hold, or could not be judged. */
    FAILED,
    /** Neither, and somebody accepted that. */
    SKIPPED
  }

  /** Copies the list. */
  public Trial {
    Objects.requireNonNull(kind);
    Objects.requireNonNull(name);
    Objects.requireNonNull(outcome);
    Objects.requireNonNull(text);
    findings = List.copyOf(findings);
  }
}

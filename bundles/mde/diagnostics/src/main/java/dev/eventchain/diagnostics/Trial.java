package dev.eventchain.diagnostics;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * A test that a command made of the software, with its outcome.
 *
 * @param name unique among those of its kind
 * @param text what was measured or is missing, in words; may be empty
 * @param seconds the simulated time that it took, in s: equal for equal inputs
 * @param findings those findings of the command that are about it
 * @param evidence what it says about requirements; empty if it is no evidence by itself
 * @param figures what else tools may read of a test that is no evidence, by names, in their order
 */
public record Trial(
    Kind kind,
    String name,
    Outcome outcome,
    String text,
    double seconds,
    List<Diagnostic> findings,
    Optional<Evidence> evidence,
    Map<String, String> figures) {

  /** Subject of the test. */
  public enum Kind {
    /** The software in a situation. */
    SCENARIO("scenarios"),
    /** One expectation of a scenario. */
    CRITERION("criteria"),
    /** A written requirement, by all that names it. */
    REQUIREMENT("requirements"),
    /** The software in a situation in which something breaks. */
    FAULT("faults"),
    /** A component alone, by calls with expected results. */
    TEST("component tests"),
    /** The software in one of many situations that differ in numbers only. */
    CASE("cases");

    private final String title;

    Kind(String title) {
      this.title = title;
    }

    /** Returns the name of all tests of this kind. */
    public String title() {
      return title;
    }
  }

  /** Possible outcomes. */
  public enum Outcome {
    PASSED,
    /** It did not hold, or could not be judged. */
    FAILED,
    /** It could not be judged, and the findings of the command fail other tests for that. */
    UNTESTED,
    /** Neither, and somebody accepted that. */
    SKIPPED
  }

  /**
   * The requirements for which the outcome of a test holds.
   *
   * @param place where the test is written
   * @param fully those of which nothing remains to be shown
   * @param partially the others
   */
  public record Evidence(SourceLocation place, List<String> fully, List<String> partially) {

    /** Copies the lists. */
    public Evidence {
      Objects.requireNonNull(place);
      fully = List.copyOf(fully);
      partially = List.copyOf(partially);
    }
  }

  /** Creates a test that is no evidence by itself. */
  public Trial(
      Kind kind,
      String name,
      Outcome outcome,
      String text,
      double seconds,
      List<Diagnostic> findings) {
    this(kind, name, outcome, text, seconds, findings, Optional.empty());
  }

  /** Creates a test without figures. */
  public Trial(
      Kind kind,
      String name,
      Outcome outcome,
      String text,
      double seconds,
      List<Diagnostic> findings,
      Optional<Evidence> evidence) {
    this(kind, name, outcome, text, seconds, findings, evidence, Map.of());
  }

  /** Returns a copy with figures. */
  public Trial withFigures(Map<String, String> others) {
    return new Trial(kind, name, outcome, text, seconds, findings, evidence, others);
  }

  /** Copies what may be changed. */
  public Trial {
    Objects.requireNonNull(kind);
    Objects.requireNonNull(name);
    Objects.requireNonNull(outcome);
    Objects.requireNonNull(text);
    findings = List.copyOf(findings);
    figures = Collections.unmodifiableMap(new LinkedHashMap<>(figures));
  }
}

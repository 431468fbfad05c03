package dev.eventchain.diagnostics;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * Checks that a command ran. They tell "nothing found" from "nothing checked".
 *
 * @param files the names of the files that were read and checked, in order
 * @param elements the number of elements in the models
 * @param checks the checks that ran, in order
 */
public record Coverage(List<String> files, long elements, List<Check> checks) {

  /** Coverage of a command that checked nothing. */
  public static final Coverage NONE = new Coverage(List.of(), 0, List.of());

  /** Kind of a check. */
  public enum Kind {
    /** Constraint of the model, standard or written by the user. */
    CONSTRAINT("constraints"),
    /** Contract between the publishers and subscribers of a topic. */
    CONTRACT("message contracts"),
    /** Requirement of the metamodel on any model: multiplicities, opposites, keys. */
    METAMODEL("metamodel checks");

    private final String title;

    Kind(String title) {
      this.title = title;
    }

    /** Returns the name of all checks of this kind. */
    public String title() {
      return title;
    }
  }

  /**
   * A check that ran.
   *
   * @param id the id of its findings
   * @param rule the user's rule, such as an OCL constraint's qualified name; empty if the id
   *     suffices
   * @param severity the severity of its findings
   * @param location the location of the rule; {@link SourceLocation#NONE} if it is built in
   * @param hint how to resolve its findings; may be empty
   * @param evaluations the number of evaluations; 0 if it applied to nothing
   */
  public record Check(
      Kind kind,
      String id,
      String rule,
      Severity severity,
      SourceLocation location,
      String hint,
      long evaluations) {

    /** Refuses nulls; unknown values are empty. */
    public Check {
      Objects.requireNonNull(kind);
      Objects.requireNonNull(id);
      Objects.requireNonNull(rule);
      Objects.requireNonNull(severity);
      Objects.requireNonNull(location);
      Objects.requireNonNull(hint);
    }

    private Check plus(Check other) {
      return new Check(kind, id, rule, severity, location, hint, evaluations + other.evaluations);
    }

    /** Returns the display name. */
    public String name() {
      return rule.isEmpty() ? id : rule;
    }
  }

  /** Copies the lists. */
  public Coverage {
    files = List.copyOf(files);
    checks = List.copyOf(checks);
  }

  /** Returns a number with its noun: {@code 1 element}, {@code 2 elements}. */
  public static String counted(long number, String what) {
    return number + " " + what + (number == 1 ? "" : "s");
  }

  /** Returns the number of constraints. */
  public long constraints() {
    return checks.stream().filter(check -> check.kind == Kind.CONSTRAINT).count();
  }

  /** Returns the number of evaluations of the checks of a kind. */
  public long evaluations(Kind kind) {
    return checks.stream().filter(check -> check.kind == kind).mapToLong(Check::evaluations).sum();
  }

  /**
   * Returns the union of both coverages. A check that ran in both counts once, with the sum of its
   * evaluations.
   */
  public Coverage and(Coverage other) {
    Set<String> allFiles = new LinkedHashSet<>(files);
    allFiles.addAll(other.files);
    Map<String, Check> merged = new LinkedHashMap<>();
    for (List<Check> each : List.of(checks, other.checks)) {
      for (Check check : each) {
        merged.merge(check.kind + " " + check.id + " " + check.rule, check, Check::plus);
      }
    }
    return new Coverage(
        new ArrayList<>(allFiles), elements + other.elements, new ArrayList<>(merged.values()));
  }
}

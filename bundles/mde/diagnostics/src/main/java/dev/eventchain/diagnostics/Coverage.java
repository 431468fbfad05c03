package dev.eventchain.diagnostics;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * What a command has checked, so that "nothing found" and "nothing looked at" are not the same.
 *
 * @param files the files that were read and checked, as people know them, in order
 * @param elements how many elements the models have
 * @param checks the checks that ran, in order
 */
public record Coverage(List<String> files, long elements, List<Check> checks) {

  /** Nothing was checked. */
  public static final Coverage NONE = new Coverage(List.of(), 0, List.of());

  /** What a check is about. */
  public enum Kind {
    /** A constraint of the model: standard, or written by the user. */
    CONSTRAINT("constraints"),
    /** What two ends of a topic promise each other. */
    CONTRACT("message contracts"),
    /** What the metamodel itself demands of any model: multiplicities, opposites, keys. */
    METAMODEL("metamodel checks");

    private final String title;

    Kind(String title) {
      this.title = title;
    }

    /** The name of all checks of this kind. */
    String title() {
      return title;
    }
  }

  /**
   * A check that ran.
   *
   * @param id the id of the finding that it reports
   * @param rule the user's rule, such as an OCL constraint's qualified name; empty if the id says
   *     it all
   * @param severity how bad its findings are
   * @param location where the rule is; {@link SourceLocation#NONE} if it is part of the program
   * @param hint what to do about its findings; may be empty
   * @param evaluations how often it was evaluated; 0 if there was nothing that it is about
   */
  public record Check(
      Kind kind,
      String id,
      String rule,
      Severity severity,
      SourceLocation location,
      String hint,
      long evaluations) {

    /** Refuses nulls: what is not known is empty. */
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

    /** What people call it. */
    String name() {
      return rule.isEmpty() ? id : rule;
    }
  }

  /** Keeps the lists from changing. */
  public Coverage {
    files = List.copyOf(files);
    checks = List.copyOf(checks);
  }

  /** How many there are of what, in words: {@code 1 element}, {@code 2 elements}. */
  public static String counted(long number, String what) {
    return number + " " + what + (number == 1 ? "" : "s");
  }

  /** How many constraints there were to evaluate. */
  public long constraints() {
    return checks.stream().filter(check -> check.kind == Kind.CONSTRAINT).count();
  }

  /** How often a check of this kind was evaluated. */
  public long evaluations(Kind kind) {
    return checks.stream().filter(check -> check.kind == kind).mapToLong(Check::evaluations).sum();
  }

  /** What both have checked; a check that ran in both counts once, with all its evaluations. */
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

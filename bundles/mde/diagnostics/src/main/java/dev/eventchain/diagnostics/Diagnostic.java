package dev.eventchain.diagnostics;

import java.util.Collection;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A finding: a problem, its location and a hint.
 *
 * @param kind the kind of finding, a constant of the bundle that reports it
 * @param severity the severity
 * @param message the problem in one sentence that names the values involved
 * @param location the location of the problem
 * @param hint how to resolve it; empty if the message suffices
 * @param rule the user's own rule that found it, such as an OCL constraint's qualified name; empty
 *     if the id suffices
 * @param related other locations involved, most relevant first: the violated rule, or the other
 *     side of a contract
 * @param cause the finding that it is a consequence of; empty if it stands for itself
 * @param changes changes of a model of which each resolves it, best first; empty if none is known
 */
public record Diagnostic(
    Rule kind,
    Severity severity,
    String message,
    SourceLocation location,
    String hint,
    String rule,
    List<SourceLocation> related,
    Optional<Cause> cause,
    List<ModelChange> changes)
    implements Comparable<Diagnostic> {

  /** Order by location, as in the file, then by all other components. */
  private static final Comparator<Diagnostic> ORDER =
      Comparator.comparing(Diagnostic::location)
          .thenComparing(Diagnostic::severity)
          .thenComparing(Diagnostic::id)
          .thenComparing(Diagnostic::rule)
          .thenComparing(Diagnostic::message)
          .thenComparing(Diagnostic::hint)
          .thenComparing(Diagnostic::related, Diagnostic::compare)
          .thenComparing(each -> each.cause.map(Cause::location).orElse(SourceLocation.NONE))
          .thenComparing(each -> each.cause.map(Cause::consequence).orElse(""))
          .thenComparing(Diagnostic::changes, Diagnostic::compare);

  /**
   * Another finding, of which a finding is a consequence: what resolves it may resolve both.
   *
   * @param location the location of the other finding, by which it is known
   * @param consequence what the finding is called in a list of the other one's consequences
   */
  public record Cause(SourceLocation location, String consequence) {

    /** Refuses nulls. */
    public Cause {
      Objects.requireNonNull(location);
      Objects.requireNonNull(consequence);
    }
  }

  /** Refuses nulls; unknown values are empty. */
  public Diagnostic {
    Objects.requireNonNull(kind);
    Objects.requireNonNull(severity);
    Objects.requireNonNull(message);
    Objects.requireNonNull(location);
    Objects.requireNonNull(hint);
    Objects.requireNonNull(rule);
    related = List.copyOf(related);
    Objects.requireNonNull(cause);
    changes = List.copyOf(changes);
  }

  /** Creates a finding that stands for itself. */
  public Diagnostic(
      Rule kind,
      Severity severity,
      String message,
      SourceLocation location,
      String hint,
      String rule,
      List<SourceLocation> related) {
    this(kind, severity, message, location, hint, rule, related, Optional.empty(), List.of());
  }

  /** Returns a finding with the severity of its kind. */
  public static Diagnostic of(Rule kind, String message, SourceLocation location) {
    return new Diagnostic(kind, kind.severity(), message, location, "", "", List.of());
  }

  /** Returns the stable dotted id of its kind, {@code ocl.violated}. */
  public String id() {
    return kind.id();
  }

  /** Returns whether it is of a kind. */
  public boolean is(Rule other) {
    return kind.id().equals(other.id());
  }

  /** Returns whether any finding is an error. */
  public static boolean anyError(Collection<Diagnostic> diagnostics) {
    return diagnostics.stream().anyMatch(diagnostic -> diagnostic.severity == Severity.ERROR);
  }

  /** Returns this finding with another severity. */
  public Diagnostic withSeverity(Severity newSeverity) {
    return new Diagnostic(
        kind, newSeverity, message, location, hint, rule, related, cause, changes);
  }

  /** Returns this finding with another hint. */
  public Diagnostic withHint(String newHint) {
    return new Diagnostic(
        kind, severity, message, location, newHint, rule, related, cause, changes);
  }

  /** Returns this finding with the user's rule that found it. */
  public Diagnostic withRule(String newRule) {
    return new Diagnostic(
        kind, severity, message, location, hint, newRule, related, cause, changes);
  }

  /** Returns this finding at another location. */
  public Diagnostic withLocation(SourceLocation newLocation) {
    return new Diagnostic(
        kind, severity, message, newLocation, hint, rule, related, cause, changes);
  }

  /** Returns this finding with other related locations, without {@code NONE}. */
  public Diagnostic withRelated(SourceLocation... places) {
    List<SourceLocation> known =
        Stream.of(places).filter(place -> !place.equals(SourceLocation.NONE)).toList();
    return new Diagnostic(kind, severity, message, location, hint, rule, known, cause, changes);
  }

  /** Returns this finding as a consequence of another one. */
  public Diagnostic withCause(Cause newCause) {
    return new Diagnostic(
        kind, severity, message, location, hint, rule, related, Optional.of(newCause), changes);
  }

  /** Returns this finding with changes that resolve it. */
  public Diagnostic withChanges(List<ModelChange> newChanges) {
    return new Diagnostic(
        kind, severity, message, location, hint, rule, related, cause, newChanges);
  }

  private static <T extends Comparable<T>> int compare(List<T> first, List<T> second) {
    Iterator<T> others = second.iterator();
    for (T each : first) {
      int order = others.hasNext() ? each.compareTo(others.next()) : 1;
      if (order != 0) {
        return order;
      }
    }
    return others.hasNext() ? -1 : 0;
  }

  @Override
  public int compareTo(Diagnostic other) {
    return ORDER.compare(this, other);
  }
}

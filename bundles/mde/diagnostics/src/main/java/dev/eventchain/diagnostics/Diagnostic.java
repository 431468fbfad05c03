package dev.eventchain.diagnostics;

import java.util.Collection;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * A finding: what is wrong, where, and what to do about it.
 *
 * @param id the stable dotted id, {@code ocl.violated}; each has a page in the rules folder of the
 *     bundle that reports it
 * @param severity how bad it is
 * @param message what is wrong: one sentence that names the values it speaks of
 * @param location where it is
 * @param hint what to do about it; empty if nothing helps that the message does not say
 * @param rule the user's own rule that found it, such as an OCL constraint's qualified name; empty
 *     if the id says it all
 * @param related other places that it is about, most telling first: where the violated rule is, or
 *     the other side of a contract
 */
public record Diagnostic(
    String id,
    Severity severity,
    String message,
    SourceLocation location,
    String hint,
    String rule,
    List<SourceLocation> related)
    implements Comparable<Diagnostic> {

  /** By place first, so that a report reads like the file; ties broken by all that is left. */
  private static final Comparator<Diagnostic> ORDER =
      Comparator.comparing(Diagnostic::location)
          .thenComparing(Diagnostic::severity)
          .thenComparing(Diagnostic::id)
          .thenComparing(Diagnostic::rule)
          .thenComparing(Diagnostic::message)
          .thenComparing(Diagnostic::hint)
          .thenComparing(Diagnostic::related, Diagnostic::compare);

  /** Refuses nulls: what is not known is empty. */
  public Diagnostic {
    Objects.requireNonNull(id);
    Objects.requireNonNull(severity);
    Objects.requireNonNull(message);
    Objects.requireNonNull(location);
    Objects.requireNonNull(hint);
    Objects.requireNonNull(rule);
    related = List.copyOf(related);
  }

  /** A finding that makes a command fail. */
  public static Diagnostic error(String id, String message, SourceLocation location) {
    return new Diagnostic(id, Severity.ERROR, message, location, "", "", List.of());
  }

  /** A finding that people should look at. */
  public static Diagnostic warning(String id, String message, SourceLocation location) {
    return new Diagnostic(id, Severity.WARNING, message, location, "", "", List.of());
  }

  /** A finding that is good to know. */
  public static Diagnostic info(String id, String message, SourceLocation location) {
    return new Diagnostic(id, Severity.INFO, message, location, "", "", List.of());
  }

  /** Whether one of the findings is an error. */
  public static boolean anyError(Collection<Diagnostic> diagnostics) {
    return diagnostics.stream().anyMatch(diagnostic -> diagnostic.severity == Severity.ERROR);
  }

  /** The same finding with another severity. */
  public Diagnostic withSeverity(Severity newSeverity) {
    return new Diagnostic(id, newSeverity, message, location, hint, rule, related);
  }

  /** The same finding with another hint. */
  public Diagnostic withHint(String newHint) {
    return new Diagnostic(id, severity, message, location, newHint, rule, related);
  }

  /** The same finding with the user's rule that found it. */
  public Diagnostic withRule(String newRule) {
    return new Diagnostic(id, severity, message, location, hint, newRule, related);
  }

  /** The same finding at another place. */
  public Diagnostic withLocation(SourceLocation newLocation) {
    return new Diagnostic(id, severity, message, newLocation, hint, rule, related);
  }

  /** The same finding with other places that it is about; those that are nowhere are left out. */
  public Diagnostic withRelated(SourceLocation... places) {
    List<SourceLocation> known =
        Stream.of(places).filter(place -> !place.equals(SourceLocation.NONE)).toList();
    return new Diagnostic(id, severity, message, location, hint, rule, known);
  }

  private static int compare(List<SourceLocation> first, List<SourceLocation> second) {
    Iterator<SourceLocation> others = second.iterator();
    for (SourceLocation place : first) {
      int order = others.hasNext() ? place.compareTo(others.next()) : 1;
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

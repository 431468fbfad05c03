package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceText;
import java.util.AbstractList;
import java.util.List;

/** Collector of the findings about one compilation unit. */
public record Problems(SourceText source, List<Diagnostic> found) {
  static final Rule SYNTAX = SyntaxRules.SYNTAX;

  /** Greatest number of problems; a file with more is not a template. */
  private static final int MOST = 1000;

  /** Returns a collector that keeps none, however many there are. */
  public static Problems ignored(SourceText source) {
    return new Problems(
        source,
        new AbstractList<>() {
          @Override
          public void add(int index, Diagnostic ignored) {}

          @Override
          public Diagnostic get(int index) {
            throw new IndexOutOfBoundsException(index);
          }

          @Override
          public int size() {
            return 0;
          }
        });
  }

  public void syntax(int offset, String message, String hint) {
    add(SYNTAX, offset, message, hint);
  }

  public void add(Rule rule, int offset, String message, String hint) {
    if (rule.severity() != Severity.ERROR || found.size() < MOST) {
      found.add(Diagnostic.of(rule, message, source.at(offset)).withHint(hint));
    } else if (found.size() == MOST) {
      String more = "There are more than " + MOST + " problems; the others are not listed.";
      found.add(Diagnostic.of(SYNTAX, more, source.at(offset)));
    }
  }

  /** Returns whether the limit of problems is reached, so that further checks are useless. */
  boolean areTooMany() {
    return found.size() > MOST;
  }

  /** Adds a finding as a warning, although others of its rule are errors. */
  public void warn(Rule rule, int offset, String message, String hint) {
    found.add(
        Diagnostic.of(rule, message, source.at(offset))
            .withSeverity(Severity.WARNING)
            .withHint(hint));
  }
}

package dev.eventchain.diagnostics;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Everything that a command reports about its input, which every {@link DiagnosticFormat} renders.
 *
 * @param version the version of the program
 * @param exitCode the exit code of the command
 * @param coverage what was checked
 * @param diagnostics what was found, in order; without what is suppressed
 * @param suppressed what was found and is suppressed
 */
public record Report(
    String version,
    int exitCode,
    Coverage coverage,
    List<Diagnostic> diagnostics,
    List<Suppressions.Suppressed> suppressed) {

  /** The exit code from which on the command could not do its work. */
  private static final int FIRST_FAILURE = 2;

  /** Keeps the lists from changing. */
  public Report {
    Objects.requireNonNull(version);
    Objects.requireNonNull(coverage);
    diagnostics = List.copyOf(diagnostics);
    suppressed = List.copyOf(suppressed);
  }

  /** Findings alone, of a command that says nothing else. */
  static Report of(List<Diagnostic> diagnostics) {
    int exitCode = Diagnostic.anyError(diagnostics) ? 1 : 0;
    return new Report("", exitCode, Coverage.NONE, diagnostics, List.of());
  }

  /** Whether the command did its work, whatever it found. */
  boolean successful() {
    return exitCode < FIRST_FAILURE;
  }

  /** What was found and checked, in a line: the same for the same input. */
  public String summary() {
    List<String> parts = new ArrayList<>();
    parts.add(Coverage.counted(count(Severity.ERROR), "error"));
    parts.add(Coverage.counted(count(Severity.WARNING), "warning"));
    if (!suppressed.isEmpty()) {
      parts.add(suppressed.size() + " suppressed");
    }
    String found = String.join(", ", parts);
    if (coverage.equals(Coverage.NONE)) {
      return found;
    }
    return found
        + " in "
        + Coverage.counted(coverage.files().size(), "file")
        + ": "
        + Coverage.counted(coverage.elements(), "element")
        + ", "
        + Coverage.counted(coverage.constraints(), "constraint")
        + " evaluated "
        + Coverage.counted(coverage.evaluations(Coverage.Kind.CONSTRAINT), "time")
        + evaluated(Coverage.Kind.CONTRACT, "message contract")
        + evaluated(Coverage.Kind.METAMODEL, "metamodel check");
  }

  private String evaluated(Coverage.Kind kind, String what) {
    boolean known = coverage.checks().stream().anyMatch(check -> check.kind() == kind);
    return known ? ", " + Coverage.counted(coverage.evaluations(kind), what) : "";
  }

  /** How many findings are this bad. */
  long count(Severity severity) {
    return diagnostics.stream().filter(found -> found.severity() == severity).count();
  }
}

package dev.eventchain.diagnostics;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Report of a command about its input, rendered alike by all formats of {@code format}.
 *
 * @param version the version of the program
 * @param exitCode the exit code of the command
 * @param coverage the checks that ran
 * @param diagnostics the findings that are not suppressed, in order
 * @param suppressed the suppressed findings
 * @param trials the tests of software, in order
 */
public record Report(
    String version,
    int exitCode,
    Coverage coverage,
    List<Diagnostic> diagnostics,
    List<Suppressions.Suppressed> suppressed,
    List<Trial> trials) {

  /** Lowest exit code of a command that could not do its work. */
  private static final int FIRST_FAILURE = 2;

  /** Copies the lists. */
  public Report {
    Objects.requireNonNull(version);
    Objects.requireNonNull(coverage);
    diagnostics = List.copyOf(diagnostics);
    suppressed = List.copyOf(suppressed);
    trials = List.copyOf(trials);
  }

  /** Creates the report of a command that tested no software. */
  public Report(
      String version,
      int exitCode,
      Coverage coverage,
      List<Diagnostic> diagnostics,
      List<Suppressions.Suppressed> suppressed) {
    this(version, exitCode, coverage, diagnostics, suppressed, List.of());
  }

  /** Returns a report with findings alone. */
  public static Report of(List<Diagnostic> diagnostics) {
    int exitCode = Diagnostic.anyError(diagnostics) ? 1 : 0;
    return new Report("", exitCode, Coverage.NONE, diagnostics, List.of());
  }

  /** Returns whether the command did its work, whatever the findings. */
  public boolean successful() {
    return exitCode < FIRST_FAILURE;
  }

  /** Returns a line about findings and checks; equal for equal inputs. */
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

  /** Returns the number of findings of a severity. */
  public long count(Severity severity) {
    return diagnostics.stream().filter(found -> found.severity() == severity).count();
  }
}

package dev.eventchain.pipeline;

import static java.util.stream.Collectors.joining;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.Suppressions.Suppressed;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.pipeline.run.RunResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * How a command ended.
 *
 * @param failed whether it could not do its work, and the findings say why
 * @param run the run of the project's stages, when there was one
 * @param written what was written without a project, for people; may be empty
 */
public record Outcome(
    int exitCode,
    boolean failed,
    Coverage coverage,
    List<Diagnostic> diagnostics,
    List<Suppressed> suppressed,
    Optional<RunResult> run,
    String written) {

  /** Of a command that did its work. */
  public static Outcome of(Coverage coverage, List<Diagnostic> found, List<Suppressed> suppressed) {
    int code = Diagnostic.anyError(found) ? ExitCode.FINDINGS : ExitCode.FINE;
    return new Outcome(code, false, coverage, found, suppressed, Optional.empty(), "");
  }

  /** Of a run of stages. */
  public static Outcome of(RunResult run) {
    boolean wanting =
        run.verdict() == RunResult.Verdict.FAILED || Diagnostic.anyError(run.diagnostics());
    int code = run.failure().map(ExitCode::of).orElse(wanting ? ExitCode.FINDINGS : ExitCode.FINE);
    return new Outcome(
        code, false, run.coverage(), run.diagnostics(), run.suppressed(), Optional.of(run), "");
  }

  /**
   * Of a command whose findings do not decide how it ended, such as an evaluation.
   *
   * @param failure why it is not whole, if it is not
   */
  public static Outcome of(Optional<DiagnosticException.Reason> failure, List<Diagnostic> found) {
    return new Outcome(
        failure.map(ExitCode::of).orElse(ExitCode.FINE),
        false,
        Coverage.NONE,
        found,
        List.of(),
        Optional.empty(),
        "");
  }

  /** Every failure is a finding; one that is not is a defect of this program, and says so. */
  public static Outcome of(Throwable failure) {
    if (failure instanceof DiagnosticException known) {
      return failed(ExitCode.of(known.reason()), known.diagnostics());
    }
    Diagnostic finding =
        MemoryFinding.in(failure)
            .or(() -> FilesFinding.in(failure))
            .orElseGet(() -> defect(failure));
    return failed(ExitCode.UNAVAILABLE, List.of(finding));
  }

  /** Says that this program itself is wrong, with the place in its code, and what it was at. */
  private static Diagnostic defect(Throwable failure) {
    StackTraceElement[] stack = failure.getStackTrace();
    String place = stack.length == 0 ? "" : " at " + stack[0];
    return Diagnostic.error(
            "eventchain.defect",
            "This is a defect in eventchain: " + failure + place,
            DiagnosticException.placeOf(failure))
        .withHint("Report it with the command and the input that led to it.");
  }

  private static Outcome failed(int exitCode, List<Diagnostic> diagnostics) {
    return new Outcome(exitCode, true, Coverage.NONE, diagnostics, List.of(), Optional.empty(), "");
  }

  /** The same with what came up while the reports were written, which makes the command fail. */
  public Outcome unreported(List<Diagnostic> problems) {
    if (problems.isEmpty()) {
      return this;
    }
    List<Diagnostic> all = new ArrayList<>(diagnostics);
    all.addAll(problems);
    return new Outcome(ExitCode.INPUT, failed, coverage, all, suppressed, run, written);
  }

  /** What both came to: the worse of their codes, and everything that was found. */
  public Outcome and(Outcome other) {
    return new Outcome(
        Math.max(exitCode, other.exitCode),
        failed || other.failed,
        coverage.and(other.coverage),
        joined(diagnostics, other.diagnostics),
        joined(suppressed, other.suppressed),
        run.or(other::run),
        Stream.of(written, other.written).filter(text -> !text.isEmpty()).collect(joining("; ")));
  }

  private static <T> List<T> joined(List<T> first, List<T> second) {
    return Stream.concat(first.stream(), second.stream()).toList();
  }

  /**
   * What the outcome says, for every format.
   *
   * @param version that of the program
   */
  public Report report(String version) {
    return new Report(version, exitCode, coverage, diagnostics, suppressed);
  }

  /**
   * Findings without a project, parted by what its people have decided, and warnings about that.
   */
  public static Outcome of(Coverage coverage, List<Diagnostic> found, Suppressions suppressions) {
    Suppressions.Parted parted = suppressions.part(found);
    List<Diagnostic> remaining = new ArrayList<>(parted.remaining());
    remaining.addAll(suppressions.warnings(found, coverage, false));
    return of(coverage, remaining, parted.suppressed());
  }

  /** Of a command that wrote files without a project. */
  public static Outcome of(WrittenFiles files, Suppressions suppressions) {
    Outcome judged = of(Coverage.NONE, files.diagnostics(), suppressions);
    return new Outcome(
        judged.exitCode,
        false,
        Coverage.NONE,
        judged.diagnostics,
        judged.suppressed,
        Optional.empty(),
        files.summary());
  }
}

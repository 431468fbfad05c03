package dev.eventchain.pipeline;

import static java.util.stream.Collectors.joining;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.Suppressions.Suppressed;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.pipeline.run.RunResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The outcome of a command.
 *
 * @param failed true if the command could not do its work; the findings say why
 * @param run the run of the project's stages, when there was one
 * @param written the files written without a project, as readable text; may be empty
 * @param trials the tests that the command made apart from a run
 */
public record Outcome(
    int exitCode,
    boolean failed,
    Coverage coverage,
    List<Diagnostic> diagnostics,
    List<Suppressed> suppressed,
    Optional<RunResult> run,
    String written,
    List<Trial> trials) {

  private Outcome(
      int exitCode,
      boolean failed,
      Coverage coverage,
      List<Diagnostic> diagnostics,
      List<Suppressed> suppressed,
      Optional<RunResult> run,
      String written) {
    this(exitCode, failed, coverage, diagnostics, suppressed, run, written, List.of());
  }

  /** Returns the outcome with the tests that the command made apart from a run. */
  public Outcome with(List<Trial> tests) {
    return new Outcome(
        exitCode, failed, coverage, diagnostics, suppressed, run, written, List.copyOf(tests));
  }

  /** Returns the outcome of a command that did its work. */
  public static Outcome of(Coverage coverage, List<Diagnostic> found, List<Suppressed> suppressed) {
    int code = Diagnostic.anyError(found) ? ExitCode.FINDINGS : ExitCode.FINE;
    return new Outcome(code, false, coverage, found, suppressed, Optional.empty(), "");
  }

  /** Returns the outcome of a run of stages. */
  public static Outcome of(RunResult run) {
    boolean wanting =
        run.verdict() == RunResult.Verdict.FAILED || Diagnostic.anyError(run.diagnostics());
    int code = run.failure().map(ExitCode::of).orElse(wanting ? ExitCode.FINDINGS : ExitCode.FINE);
    return new Outcome(
        code, false, run.coverage(), run.diagnostics(), run.suppressed(), Optional.of(run), "");
  }

  /**
   * Returns the outcome of a command whose findings do not determine its exit code, such as an
   * evaluation.
   *
   * @param failure the reason why the result is incomplete, if it is
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

  /**
   * Turns a failure into a finding; unknown failures are defects of this program and reported as
   * such.
   */
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

  /**
   * Returns the finding about a defect of this program, with the position in its code and in the
   * input.
   */
  private static Diagnostic defect(Throwable failure) {
    StackTraceElement[] stack = failure.getStackTrace();
    String place = stack.length == 0 ? "" : " at " + stack[0];
    return Diagnostic.of(
            PipelineRules.EVENTCHAIN_DEFECT,
            "This is a defect in eventchain: " + failure + place,
            DiagnosticException.placeOf(failure))
        .withHint("Report it with the command and the input that led to it.");
  }

  private static Outcome failed(int exitCode, List<Diagnostic> diagnostics) {
    return new Outcome(exitCode, true, Coverage.NONE, diagnostics, List.of(), Optional.empty(), "");
  }

  /** Returns the outcome with the failures of writing reports, which make the command fail. */
  public Outcome unreported(List<Diagnostic> problems) {
    if (problems.isEmpty()) {
      return this;
    }
    List<Diagnostic> all = new ArrayList<>(diagnostics);
    all.addAll(problems);
    return new Outcome(ExitCode.INPUT, failed, coverage, all, suppressed, run, written, trials);
  }

  /** Returns the combination of two outcomes: the worse exit code, and the findings of both. */
  public Outcome and(Outcome other) {
    return new Outcome(
        Math.max(exitCode, other.exitCode),
        failed || other.failed,
        coverage.and(other.coverage),
        joined(diagnostics, other.diagnostics),
        joined(suppressed, other.suppressed),
        run.or(other::run),
        Stream.of(written, other.written).filter(text -> !text.isEmpty()).collect(joining("; ")),
        joined(trials, other.trials));
  }

  private static <T> List<T> joined(List<T> first, List<T> second) {
    return Stream.concat(first.stream(), second.stream()).toList();
  }

  /**
   * Returns the report of the outcome, for every format.
   *
   * @param version the version of the program
   */
  public Report report(String version) {
    return new Report(
        version,
        exitCode,
        coverage,
        diagnostics,
        suppressed,
        run.map(RunResult::trials).orElse(trials));
  }

  /**
   * Returns the outcome for findings without a project, with suppressions applied, and warnings
   * about these.
   */
  public static Outcome of(Coverage coverage, List<Diagnostic> found, Suppressions suppressions) {
    Suppressions.Parted parted = suppressions.part(found);
    List<Diagnostic> remaining = new ArrayList<>(parted.remaining());
    remaining.addAll(suppressions.warnings(found, coverage, false));
    return of(coverage, remaining, parted.suppressed());
  }

  /** Returns the outcome of a command that wrote files without a project. */
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

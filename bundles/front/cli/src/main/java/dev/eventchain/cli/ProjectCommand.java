package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.console.ProgressLines;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.cli.options.ReportOptions;
import dev.eventchain.cli.options.ScenarioOptions;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.Pipeline;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import dev.eventchain.project.ProjectFolder;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalDate;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Base class of all commands that read models or a project and end with a report. */
abstract class ProjectCommand implements Callable<Integer> {

  /** Largest number of findings of one rule that is printed; a report file has all. */
  private static final int MOST_OF_ONE_RULE = 100;

  private final Console console;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "FOLDER",
      description = "Where to write (default: DIR/out).")
  private Path output;

  @Mixin private ReportOptions reporting;

  @Option(
      names = "--overwrite",
      description = "Replace files in the output folder that were edited by hand.")
  private boolean overwrite;

  @Option(
      names = "--time-limit",
      paramLabel = "SECONDS",
      defaultValue = "30",
      description =
          "The processor time that a constraint, or the patterns of a data type, may take on the"
              + " whole model (default: ${DEFAULT-VALUE}); all of them may take four times as"
              + " much.")
  private int timeLimit;

  @Spec private CommandSpec spec;

  ProjectCommand(Console console) {
    this.console = console;
  }

  /**
   * Does the work of the command.
   *
   * @throws ParameterException if it was used wrongly
   */
  abstract Outcome work();

  @Override
  public final Integer call() {
    long start = System.nanoTime();
    reporting.check(hasEvidence());
    reporting.removeEarlier();
    if (output != null && output.toString().isEmpty()) {
      throw wrongUsage("the name of the output folder is empty: -o FOLDER");
    }
    if (timeLimit < 1) {
      throw wrongUsage("the time limit must be a number of seconds: --time-limit 60");
    }
    Outcome outcome = outcome();
    double seconds = (System.nanoTime() - start) / 1e9;
    try {
      return report(outcome, seconds);
    } catch (OutOfMemoryError e) {
      // Reports of success must not stand next to failed reports.
      return report(Outcome.of(e), seconds);
    }
  }

  /** Does the work and catches all failures, since each must reach the reports. */
  private Outcome outcome() {
    try {
      return work();
    } catch (ParameterException e) {
      throw e;
    } catch (RuntimeException | Error e) {
      return Outcome.of(e);
    }
  }

  /** Returns whether the command may come to a verdict, of which there are reports. */
  boolean hasEvidence() {
    return false;
  }

  /** Returns whether standard output is for the command's result, so that findings go elsewhere. */
  boolean printsResult() {
    return false;
  }

  /** Prints text that is not a finding. */
  final void print(String text) {
    PrintWriter writer = printsResult() ? console.out() : console.err();
    writer.print(text);
    if (!printsResult() && !text.isEmpty() && !text.endsWith("\n")) {
      writer.println(); // findings follow
    }
    writer.flush();
  }

  private PrintWriter findings() {
    return printsResult() ? console.err() : console.out();
  }

  final Path output() {
    return output;
  }

  /** Returns the processor time that a constraint may take on the whole model. */
  final Duration timeLimit() {
    return Duration.ofSeconds(timeLimit);
  }

  /** Returns what becomes of files in the output folder that were edited by hand. */
  final OnEdit onEdit() {
    return overwrite ? OnEdit.OVERWRITE : OnEdit.KEEP;
  }

  /** Returns whether there are options about an output folder. */
  final boolean namesOutput() {
    return output != null || overwrite;
  }

  final ParameterException wrongUsage(String message) {
    return new ParameterException(spec.commandLine(), message);
  }

  /** Returns the suppressions outside a project. */
  final Suppressions suppressions() {
    return reporting.suppressions(Optional.empty(), console.today());
  }

  /** Returns the suppressions of a project. */
  final Suppressions suppressions(ProjectFolder project) {
    return reporting.suppressions(project.suppressions(), console.today());
  }

  /** Returns the file of suppressions that the command line names. */
  final Optional<Path> suppressionsFile() {
    return reporting.suppressionsFile();
  }

  /** Returns the day for which suppressions and acceptances are evaluated. */
  final LocalDate day() {
    return reporting.day(console.today());
  }

  /** Returns the format of findings on standard output. */
  final DiagnosticFormat format() {
    return reporting.format();
  }

  /** Returns the output folder of a project. */
  final Path outputOf(Project project) {
    return output == null ? project.defaultOutput() : output;
  }

  /** Runs stages of a project. */
  final Outcome execute(Project project, Stages stages, LlmOptions llm, ScenarioOptions scenarios) {
    return execute(project, outputOf(project), stages, llm, scenarios);
  }

  /** As above, with an output folder other than that of the command. */
  final Outcome execute(
      Project project, Path results, Stages stages, LlmOptions llm, ScenarioOptions scenarios) {
    RunOptions options = runOptions(project, results, stages, llm, scenarios);
    return Outcome.of(
        Pipeline.run(project, options, new ProgressLines(console.err(), console.terminal())));
  }

  /** Returns the options of a run up to the generation of nodes, into the command's output. */
  final RunOptions upToGeneration(Project project, LlmOptions llm) {
    return runOptions(
        project, outputOf(project), Stages.upTo(Stage.GENERATE), llm, new ScenarioOptions());
  }

  /** Returns the options of a run. */
  final RunOptions runOptions(
      Project project, Path results, Stages stages, LlmOptions llm, ScenarioOptions scenarios) {
    return new RunOptions(
        results,
        stages,
        llm.answers(),
        onEdit(),
        given(scenarios::simulation),
        scenarios.compared(),
        suppressions(project),
        timeLimit());
  }

  /** Returns what options say together. */
  private <T> T given(Supplier<T> options) {
    try {
      return options.get();
    } catch (IllegalArgumentException e) {
      throw wrongUsage(e.getMessage());
    }
  }

  /** As above, from a project's folder, for a run that may reach a verdict. */
  final Outcome execute(Path folder, Stages stages, LlmOptions llm, ScenarioOptions scenarios) {
    try {
      return execute(Project.open(folder), stages, llm, scenarios);
    } catch (DiagnosticException e) {
      // The project or its suppressions cannot be read, so the subject of a verdict is unknown.
      if (stages.last().compareTo(Stage.SIMULATE) >= 0) {
        Pipeline.withdrawVerdict(
            output == null ? new ProjectFolder(folder).defaultOutput() : output);
      }
      throw e;
    }
  }

  private int report(Outcome outcome, double seconds) {
    List<Diagnostic> unwritten =
        reporting.targets().stream()
            .flatMap(target -> target.write(outcome, Main.version()).stream())
            .toList();
    Outcome last = outcome.unreported(unwritten);
    if (reporting.format() == DiagnosticFormat.TEXT) {
      printText(last);
    } else {
      findings().print(reporting.format().render(last.report(Main.version())));
    }
    console.out().flush();
    if (outcome.failed() || !unwritten.isEmpty()) {
      List<Diagnostic> shown = outcome.failed() ? last.diagnostics() : unwritten;
      console.err().print(DiagnosticFormat.TEXT.render(shown));
    }
    if (!last.written().isEmpty()) {
      console.err().println(last.written());
    }
    if (!last.coverage().equals(Coverage.NONE)) {
      console
          .err()
          .printf(Locale.ROOT, "%s; %.2f s%n", last.report(Main.version()).summary(), seconds);
    }
    console.err().flush();
    return last.exitCode();
  }

  private void printText(Outcome outcome) {
    if (!outcome.failed()) {
      Report report = outcome.report(Main.version());
      findings()
          .print(
              reporting.areAllPrinted()
                  ? DiagnosticFormat.textOfAll(report)
                  : DiagnosticFormat.textExcerpt(report, MOST_OF_ONE_RULE));
    }
    outcome.run().ifPresent(this::printVerdict);
  }

  private void printVerdict(RunResult result) {
    for (RunResult.ScenarioLine line : result.scenarios()) {
      console.out().printf(Locale.ROOT, "%-6s  %-28s %s%n", word(line), line.name(), line.text());
    }
    for (RunResult.FaultLine line : result.faults()) {
      console.out().printf(Locale.ROOT, "%-6s  %-28s %s%n", word(line), line.name(), line.text());
    }
    for (RunResult.RequirementLine line : result.requirements()) {
      console
          .out()
          .printf(Locale.ROOT, "%-11s %s: %s%n", line.outcome(), line.id(), line.strength());
    }
    boolean judged =
        result.verdict() != RunResult.Verdict.INCOMPLETE
            || result.failure().isPresent()
            || Diagnostic.anyError(result.diagnostics());
    boolean summarized = !judged && !result.coverage().equals(Coverage.NONE);
    if (!summarized || !result.scenarios().isEmpty()) {
      console.out().println((judged ? result.verdict() + ": " : "") + result.summary());
    }
    result.report().ifPresent(report -> console.out().println("Report: " + report));
    result.recordings().forEach(file -> console.out().println("Recording: " + file));
  }

  private static String word(RunResult.ScenarioLine line) {
    return word(line.tested(), line.passed());
  }

  private static String word(RunResult.FaultLine line) {
    return word(line.tested(), line.passed());
  }

  private static String word(boolean tested, boolean passed) {
    if (!tested) {
      return "-";
    }
    return passed ? "passed" : "FAILED";
  }
}

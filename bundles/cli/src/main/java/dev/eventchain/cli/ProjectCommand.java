package dev.eventchain.cli;

import dev.eventchain.diagnostics.DiagnosticFormat;
import dev.eventchain.pipeline.Pipeline;
import dev.eventchain.pipeline.Project;
import dev.eventchain.pipeline.RunOptions;
import dev.eventchain.pipeline.RunResult;
import dev.eventchain.pipeline.Stage;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine.Option;

/** What all commands on a project's folder share. */
abstract class ProjectCommand {

  private final Console console;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "FOLDER",
      description = "Where to write (default: DIR/out).")
  private Path output;

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description = "How findings are written to standard output: ${COMPLETION-CANDIDATES}.")
  private DiagnosticFormat format;

  @Option(
      names = "--overwrite",
      description = "Replace files in the output folder that a person has edited.")
  private boolean overwrite;

  ProjectCommand(Console console) {
    this.console = console;
  }

  final Console console() {
    return console;
  }

  final Path output() {
    return output;
  }

  final boolean overwrite() {
    return overwrite;
  }

  final DiagnosticFormat format() {
    return format;
  }

  /** Runs stages of a project and reports. */
  final int execute(
      Path folder, Stage first, Stage last, boolean again, LlmOptions llm, List<String> scenarios) {
    Project project = Project.open(folder);
    RunOptions options =
        new RunOptions(
            output == null ? project.defaultOutput() : output,
            first,
            last,
            again,
            Optional.ofNullable(llm.llm),
            llm.record,
            overwrite,
            scenarios);
    RunResult result =
        Pipeline.run(project, options, new ProgressLines(console.err(), console.terminal()));
    return report(result);
  }

  private int report(RunResult result) {
    int findings = console.report(result.diagnostics(), format);
    if (format == DiagnosticFormat.TEXT) {
      writeVerdict(result);
    }
    if (result.failure().isPresent()) {
      return ExitCode.of(result.failure().get());
    }
    return result.verdict() == RunResult.Verdict.FAILED ? ExitCode.FINDINGS : findings;
  }

  private void writeVerdict(RunResult result) {
    for (RunResult.ScenarioLine line : result.scenarios()) {
      console
          .out()
          .printf(
              Locale.ROOT,
              "%s  %-28s %s%n",
              line.passed() ? "passed" : "FAILED",
              line.name(),
              line.text());
    }
    boolean judged =
        result.verdict() != RunResult.Verdict.INCOMPLETE || result.failure().isPresent();
    console.out().println((judged ? result.verdict() + ": " : "") + result.summary());
    result.report().ifPresent(report -> console.out().println("Report: " + report));
    console.out().flush();
  }
}

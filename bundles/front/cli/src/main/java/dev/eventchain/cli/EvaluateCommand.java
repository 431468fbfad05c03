package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.console.RunLines;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.evaluation.EvaluationOptions;
import dev.eventchain.pipeline.evaluation.EvaluationOutcome;
import dev.eventchain.pipeline.evaluation.LanguageModelEvaluation;
import dev.eventchain.pipeline.project.Project;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code evaluate}: measures how often language models succeed. */
@Command(
    name = "evaluate",
    mixinStandardHelpOptions = true,
    description = {
      "Compare language models.",
      "Each performs all tasks in several runs of the project, from its"
          + " requirements to the verdict of its scenarios. How often the chain model is valid,"
          + " the function code passes its checks, and all of it works, is counted twice: with"
          + " the first answers, and with those after repair. Results are in OUTPUT/evaluation,"
          + " with a folder for each run. The same command continues where it was interrupted."
    },
    footer = {
      "",
      "Exit codes: 0 evaluated, whatever the results; 1 no run could be counted;",
      "2 wrong usage or unreadable input; 3 a service could not be reached, or the budget is",
      "spent; 4 waiting for an answer; 130 interrupted."
    })
final class EvaluateCommand extends ProjectCommand {

  private final Console console;

  @Parameters(arity = "0..1", paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Option(
      names = "--models",
      paramLabel = "MODEL",
      split = ",",
      description =
          "The models, named as in eventchain.yaml (default: those that it names for any task).")
  private List<String> models = List.of();

  @Option(
      names = "--runs",
      paramLabel = "NUMBER",
      defaultValue = "5",
      description = "The number of runs of each model (default: ${DEFAULT-VALUE}).")
  private int runs;

  @Option(
      names = "--parallel",
      paramLabel = "NUMBER",
      defaultValue = "1",
      description = "The number of runs at the same time (default: ${DEFAULT-VALUE}).")
  private int parallel;

  @Option(
      names = "--llm",
      paramLabel = "SOURCE",
      description =
          "Where answers come from, as for 'run' (default: as eventchain.yaml says). Run n takes"
              + " the n-th answer that the project has recorded for a prompt, so that none counts"
              + " twice; with 'replay', a run without answers of its own does not count. New"
              + " answers are recorded in the folder of the run.")
  private String llm;

  @Option(names = "--schema", description = "Print the JSON Schema of evaluation.json instead.")
  private boolean schema;

  EvaluateCommand(Console console) {
    super(console);
    this.console = console;
  }

  @Override
  Outcome work() {
    if (schema == (folder != null)) {
      throw wrongUsage("name a project's folder, or use --schema");
    }
    if (schema) {
      console.out().print(LanguageModelEvaluation.schema());
      return Outcome.of(Coverage.NONE, List.of(), List.of());
    }
    Project project = Project.open(folder);
    EvaluationOutcome result =
        LanguageModelEvaluation.run(
            project, options(project), new RunLines(console.err(), console.terminal()));
    if (format() == DiagnosticFormat.TEXT) {
      console.out().print(result.table());
      result.files().forEach(file -> console.out().println("Report: " + file));
    }
    return Outcome.of(result.failure(), result.diagnostics());
  }

  private EvaluationOptions options(Project project) {
    try {
      return new EvaluationOptions(
              outputOf(project),
              models,
              runs,
              parallel,
              Optional.ofNullable(llm),
              suppressions(project),
              timeLimit())
          .in(project);
    } catch (IllegalArgumentException e) {
      throw wrongUsage(e.getMessage());
    }
  }
}

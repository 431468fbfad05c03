package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.console.ProgressLines;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.cli.options.ScenarioOptions;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.mutation.MutationOptions;
import dev.eventchain.pipeline.mutation.MutationOutcome;
import dev.eventchain.pipeline.mutation.MutationTesting;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code mutate}: tries which small defects of components their tests and the scenarios notice. */
@Command(
    name = "mutate",
    mixinStandardHelpOptions = true,
    description = {
      "Try which small defects of its components a project's tests and scenarios notice.",
      "The project is run first, as far as it has changed, and has to pass. Then each place of each"
          + " component gets each defect that applies: a comparison, a number by 1 and 10 %%, a sign,"
          + " a unit, an index, a dropped branch, state that is not updated, swapped inputs, an early"
          + " return, an output that stays. A defect that no component test and no scenario notices"
          + " is a finding, unless DIR/mutants.yaml accepts it with a reason. Results are in"
          + " OUTPUT/mutants.json. The same command continues where it was interrupted."
    })
final class MutateCommand extends ProjectCommand {

  private final Console console;

  @Parameters(paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Option(
      names = "--component",
      paramLabel = "NAME",
      description = "Mutate this component only; may be repeated.")
  private List<String> components = List.of();

  @Option(
      names = "--since",
      paramLabel = "REVISION",
      description =
          "Mutate only lines that have changed since this revision of Git, such as HEAD or main;"
              + " lines of files that Git does not know count as changed.")
  private String since;

  @Mixin private LlmOptions llm;

  MutateCommand(Console console) {
    super(console);
    this.console = console;
  }

  @Override
  Outcome work() {
    Project project = Project.open(folder);
    MutationOptions options = new MutationOptions(components, Optional.ofNullable(since), day());
    MutationOutcome result =
        MutationTesting.run(
            project,
            runOptions(
                project, outputOf(project), Stages.upTo(Stage.REPORT), llm, new ScenarioOptions()),
            options,
            new ProgressLines(console.err(), console.terminal()));
    if (format() == DiagnosticFormat.TEXT) {
      console.out().print(result.table());
    }
    return result.outcome();
  }
}

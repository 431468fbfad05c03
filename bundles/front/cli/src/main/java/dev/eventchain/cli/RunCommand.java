package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.cli.options.ScenarioOptions;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code run}: from requirements to a verdict. */
@Command(
    name = "run",
    mixinStandardHelpOptions = true,
    description = "Turn requirements into a verdict, a report and a measured model.")
final class RunCommand extends ProjectCommand {

  @Parameters(paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Option(
      names = "--from",
      paramLabel = "STAGE",
      defaultValue = "design",
      description = "The first stage: ${COMPLETION-CANDIDATES}.")
  private Stage from;

  @Option(
      names = "--to",
      paramLabel = "STAGE",
      defaultValue = "report",
      description = "The last stage.")
  private Stage to;

  @Option(names = "--again", description = "Run stages even if nothing has changed.")
  private boolean again;

  @Mixin private ScenarioOptions scenarios;

  @Mixin private LlmOptions llm;

  RunCommand(Console console) {
    super(console);
  }

  @Override
  boolean hasEvidence() {
    return true;
  }

  @Override
  Outcome work() {
    if (from.compareTo(to) > 0) {
      throw wrongUsage(
          "the stage " + from.id() + " (--from) comes after the stage " + to.id() + " (--to)");
    }
    boolean simulates = from.compareTo(Stage.SIMULATE) <= 0 && to.compareTo(Stage.SIMULATE) >= 0;
    if (scenarios.areRecorded() && !simulates) {
      throw wrongUsage("--mcap records a simulation, but the stage simulate is not run");
    }
    if (scenarios.faults().isPresent() && !simulates) {
      throw wrongUsage("--faults applies to a simulation, but the stage simulate is not run");
    }
    if (scenarios.areAttached() && !simulates) {
      throw wrongUsage("--attach applies to a simulation, but the stage simulate is not run");
    }
    return execute(folder, new Stages(from, to, again), llm, scenarios);
  }
}

package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.console.ProgressLines;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.cli.options.ScenarioOptions;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.campaign.CampaignOptions;
import dev.eventchain.pipeline.campaign.CampaignOutcome;
import dev.eventchain.pipeline.campaign.Campaigns;
import dev.eventchain.pipeline.campaign.Suites;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The commands that always run a single stage anew. */
final class StageCommands {

  private StageCommands() {}

  /** A stage that asks a language model. */
  private abstract static class Asking extends ProjectCommand {

    @Parameters(paramLabel = "DIR", description = "The project's folder.")
    private Path folder;

    @Mixin private LlmOptions llm;
    private final Stage stage;

    Asking(Console console, Stage stage) {
      super(console);
      this.stage = stage;
    }

    @Override
    Outcome work() {
      return execute(folder, Stages.only(stage), llm, new ScenarioOptions());
    }
  }

  @Command(
      name = "design",
      mixinStandardHelpOptions = true,
      description = "Requirements and software base to an event chain (out/chain.json).")
  static final class Design extends Asking {
    Design(Console console) {
      super(console, Stage.DESIGN);
    }
  }

  @Command(
      name = "implement",
      mixinStandardHelpOptions = true,
      description = "The chain's missing components (out/components/), checked in confinement.")
  static final class Implement extends Asking {
    Implement(Console console) {
      super(console, Stage.IMPLEMENT);
    }
  }

  @Command(
      name = "model",
      mixinStandardHelpOptions = true,
      description = "The event chain as an instance of the metamodel (out/chain.xmi).")
  static final class Model extends Asking {
    Model(Console console) {
      super(console, Stage.MODEL);
    }
  }

  @Command(
      name = "constrain",
      mixinStandardHelpOptions = true,
      description = "Design rules to OCL (out/generated.ocl), parsed and proved non-vacuous.")
  static final class Constrain extends Asking {
    Constrain(Console console) {
      super(console, Stage.CONSTRAIN);
    }
  }

  @Command(
      name = "simulate",
      mixinStandardHelpOptions = true,
      description = "The generated nodes in the closed loop: verdicts and a measured model.")
  static final class Simulate extends ProjectCommand {

    private final Console console;

    @Parameters(paramLabel = "DIR", description = "The project's folder.")
    private Path folder;

    @Option(
        names = "--suite",
        paramLabel = "NAME|FILE",
        description =
            "Simulate, instead of the project's scenarios, the cases of a suite:"
                + " euro-ncap-2023-c2c, euro-ncap-2023-vru, euro-ncap-2026-ccr, euro-ncap-2026-junction, un-r152,"
                + " un-r152-pedestrian, un-r157-alks, or those of a campaign file about scenarios of its own ('eventchain suites' says more). The"
                + " nodes are generated first, as far as something has changed. Results are in OUTPUT/campaigns.")
    private String suite;

    @Mixin private ScenarioOptions scenarios;

    Simulate(Console console) {
      super(console);
      this.console = console;
    }

    @Override
    boolean hasEvidence() {
      return suite == null;
    }

    @Override
    Outcome work() {
      return suite == null
          ? execute(folder, Stages.only(Stage.SIMULATE), new LlmOptions(), scenarios)
          : suite();
    }

    private Outcome suite() {
      if (!scenarios.areDefault()) {
        throw wrongUsage("--suite has scenarios and a driver of its own");
      }
      Project project = Project.open(folder);
      CampaignOutcome result =
          Campaigns.run(
              project,
              upToGeneration(project, new LlmOptions()),
              CampaignOptions.of(Suites.file(suite, outputOf(project))),
              new ProgressLines(console.err(), console.terminal()));
      if (format() == DiagnosticFormat.TEXT) {
        console.out().print(result.text());
      }
      return result.outcome();
    }
  }
}

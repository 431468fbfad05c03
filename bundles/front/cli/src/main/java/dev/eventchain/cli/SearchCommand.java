package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.console.ProgressLines;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.campaign.CampaignOutcome;
import dev.eventchain.pipeline.campaign.Searches;
import dev.eventchain.pipeline.project.Project;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code search}: looks for cases of a scenario that fail. */
@Command(
    name = "search",
    mixinStandardHelpOptions = true,
    description = {
      "Search for cases of a scenario that fail, by minimising the margins of its criteria.",
      "FILE is a campaign file: its factors and conditions are what is searched, and its section"
          + " 'search' says how. It may also be a scenario or distributions of its parameters in"
          + " OpenSCENARIO XML (--accept). The nodes are generated first, as far as something has changed."
          + " Each distinct failure becomes a scenario with the simplest values that fail alike."
          + " Results are in OUTPUT/searches/NAME: cases.csv, cases.json and found/. The same"
          + " command continues where it was interrupted, and comes to the same bytes. That nothing"
          + " was found does not prove that there is nothing."
    })
final class SearchCommand extends ProjectCommand {

  private final Console console;

  @Parameters(index = "0", paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Parameters(
      index = "1",
      paramLabel = "FILE",
      description = "The campaign file, or an OpenSCENARIO file.")
  private Path file;

  @Option(
      names = "--keep",
      description =
          "Copy what was found into DIR/scenarios/found, under the first free numbers; nothing is"
              + " overwritten.")
  private boolean keep;

  @Option(
      names = "--only",
      paramLabel = "NAME",
      description = "Of a file of several campaigns, only the one of this name.")
  private String only;

  @Mixin private AcceptOption accept;

  @Mixin private LlmOptions llm;

  SearchCommand(Console console) {
    super(console);
    this.console = console;
  }

  @Override
  Outcome work() {
    Project project = Project.open(folder);
    CampaignOutcome result =
        Searches.run(
            project,
            upToGeneration(project, llm),
            new Searches.Options(
                accept.search(this, project, file), Optional.ofNullable(only), keep),
            new ProgressLines(console.err(), console.terminal()));
    if (format() == DiagnosticFormat.TEXT) {
      console.out().print(result.text());
    }
    return result.outcome();
  }
}

package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.console.ProgressLines;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.campaign.CampaignEngine;
import dev.eventchain.pipeline.campaign.CampaignOptions;
import dev.eventchain.pipeline.campaign.CampaignOutcome;
import dev.eventchain.pipeline.campaign.Campaigns;
import dev.eventchain.pipeline.campaign.OpenScenarioCampaigns;
import dev.eventchain.pipeline.campaign.plan.Shard;
import dev.eventchain.pipeline.project.Project;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code campaign}: simulates many cases of a scenario. */
@Command(
    name = "campaign",
    mixinStandardHelpOptions = true,
    description = {
      "Simulate many cases of a scenario, on all processors.",
      "FILE says which numbers of which scenario differ between the cases, and by which values; or it"
          + " is a scenario or distributions of its parameters in OpenSCENARIO XML (--accept). The"
          + " nodes are generated first, as far as something has changed. A case is judged by its"
          + " criteria alone; what they prove is a matter of 'run'. Results are in"
          + " OUTPUT/campaigns/NAME: cases.csv, report.html and cases.json, those of a file of several"
          + " campaigns in a folder FILE-NAME each. The same command"
          + " continues where it was interrupted, and comes to the same bytes."
    })
final class CampaignCommand extends ProjectCommand {

  private final Console console;

  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "DIR",
      description = "The project's folder.")
  private Path folder;

  @Parameters(
      index = "1",
      arity = "0..1",
      paramLabel = "FILE",
      description = "The campaign file, or an OpenSCENARIO file.")
  private Path file;

  @Option(names = "--schema", description = "Print the JSON Schema of campaign files instead.")
  private boolean schema;

  @Option(
      names = "--dry-run",
      description = "Only count the cases, and say how long they take, from ten of them.")
  private boolean dryRun;

  @Option(
      names = "--shard",
      paramLabel = "K/N",
      description =
          "Simulate only part K of N, into OUTPUT/campaigns/NAME-K-of-N, to be put together by"
              + " --merge.")
  private String shard;

  @Option(
      names = "--merge",
      paramLabel = "FOLDER",
      arity = "1..*",
      description = "Put the parts in these folders together; none may be missing or different.")
  private List<Path> merged = List.of();

  @Option(
      names = "--engine",
      paramLabel = "ray[=ADDRESS]",
      description =
          "Simulate on the nodes of a Ray cluster: of the one at ADDRESS, or 'auto' for that which"
              + " this machine is a node of; without an address, of a new one of this machine alone."
              + " Ray is installed on first use.")
  private String engine;

  @Option(
      names = "--case",
      paramLabel = "NUMBER",
      description =
          "Simulate one case of the table again: its scenario, its recording and its report are in"
              + " OUTPUT/campaigns/NAME/case-NUMBER.")
  private Integer replayed;

  @Option(
      names = "--compare",
      paramLabel = "FOLDER",
      description = "Say which cases pass now and which no longer, compared with these results.")
  private Path compared;

  @Option(
      names = "--only",
      paramLabel = "NAME",
      description = "Of a file of several campaigns, only the one of this name.")
  private String only;

  @Mixin private AcceptOption accept;

  @Mixin private LlmOptions llm;

  CampaignCommand(Console console) {
    super(console);
    this.console = console;
  }

  @Override
  Outcome work() {
    if (schema == (file != null)) {
      throw wrongUsage("name a project's folder and a campaign file, or use --schema");
    }
    if (schema) {
      console.out().print(Campaigns.schema());
      return Outcome.of(Coverage.NONE, List.of(), List.of());
    }
    requireOne();
    requireCampaignFile();
    Project project = Project.open(folder);
    CampaignOutcome result =
        Campaigns.run(
            project,
            upToGeneration(project, llm),
            new CampaignOptions(
                accept.campaign(this, project, file),
                Optional.ofNullable(only),
                dryRun,
                shard(),
                replayed(),
                merged,
                Optional.ofNullable(engine).map(this::engine),
                Optional.ofNullable(compared)),
            new ProgressLines(console.err(), console.terminal()));
    if (format() == DiagnosticFormat.TEXT) {
      console.out().print(result.text());
    }
    return result.outcome();
  }

  private void requireOne() {
    boolean only = shard != null || replayed != null || dryRun;
    if (!merged.isEmpty() && (only || engine != null)) {
      throw wrongUsage("--merge stands alone");
    }
    if (engine != null && only) {
      throw wrongUsage("--engine is for the whole campaign, without --shard, --case and --dry-run");
    }
  }

  private void requireCampaignFile() {
    if (engine != null && OpenScenarioCampaigns.isOne(file)) {
      throw wrongUsage("--engine needs a campaign file; other machines have no OUTPUT folder");
    }
  }

  private CampaignEngine engine(String text) {
    if (!text.equals("ray") && !text.matches("ray=\\S+")) {
      throw wrongUsage("the engine is --engine ray or --engine ray=ADDRESS");
    }
    List<String> options = new ArrayList<>(List.of("--date", day().toString()));
    options.addAll(List.of("--time-limit", Long.toString(timeLimit().toSeconds())));
    llm.source().ifPresent(it -> options.addAll(List.of("--llm", it)));
    Optional<Path> suppressions = suppressionsFile().map(it -> it.toAbsolutePath().normalize());
    suppressions.ifPresent(
        it -> options.addAll(List.of("--suppressions", CampaignEngine.FILES + it)));
    return new CampaignEngine(
        text.substring(Math.min(text.length(), "ray=".length())),
        options,
        suppressions.stream().toList());
  }

  private Shard shard() {
    try {
      return shard == null ? Shard.ALL : Shard.parse(shard);
    } catch (IllegalArgumentException e) {
      throw wrongUsage(e.getMessage());
    }
  }

  private OptionalInt replayed() {
    return replayed == null ? OptionalInt.empty() : OptionalInt.of(replayed);
  }
}

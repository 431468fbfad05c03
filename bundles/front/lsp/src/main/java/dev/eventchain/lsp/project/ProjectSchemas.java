package dev.eventchain.lsp.project;

import dev.eventchain.pipeline.ProjectBench;
import dev.eventchain.pipeline.campaign.CampaignFiles;
import dev.eventchain.pipeline.campaign.Campaigns;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.SuppressionFile;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;

/** The published schemas of a project's files in YAML; some kinds have none. */
final class ProjectSchemas {

  /** A kind of files with a schema. */
  enum Kind {
    SETTINGS,
    SUPPRESSIONS,
    MUTANTS,
    BENCH,
    SCENARIO,
    FAULTS,
    CAMPAIGN,
    TESTS
  }

  /** The kinds of the files in the folder of a project that have one name. */
  private static final Map<String, Kind> BY_NAME =
      Map.of(
          ProjectLayout.CONFIGURATION,
          Kind.SETTINGS,
          ProjectLayout.SUPPRESSIONS,
          Kind.SUPPRESSIONS,
          ProjectLayout.MUTANTS,
          Kind.MUTANTS,
          ProjectLayout.BENCH,
          Kind.BENCH,
          ProjectLayout.FAULTS,
          Kind.FAULTS);

  private static final String NOTHING = "{}";

  private final Map<Kind, ProjectSchema> read = new EnumMap<>(Kind.class);

  /** Returns what a file of a project is by its place or, for campaigns, by its keys. */
  static Optional<Kind> kind(Path project, Path file, String text) {
    Path inside = project.relativize(file);
    String first = inside.getName(0).toString();
    if (!file.toString().matches(".*\\.ya?ml")) {
      return Optional.empty();
    } else if (inside.getNameCount() == 1 && BY_NAME.containsKey(first)) {
      return Optional.of(BY_NAME.get(first));
    } else if (inside.getNameCount() > 1 && first.equals(ProjectLayout.SCENARIOS)) {
      return Optional.of(Kind.SCENARIO);
    } else if (inside.getNameCount() > 1 && first.equals(ProjectLayout.TESTS)) {
      return Optional.of(Kind.TESTS);
    }
    boolean isCampaign =
        (inside.getNameCount() > 1 && first.equals("campaigns")) || CampaignFiles.isCampaign(text);
    return isCampaign ? Optional.of(Kind.CAMPAIGN) : Optional.empty();
  }

  /** Returns the schema of a kind, which is read once. */
  synchronized ProjectSchema of(Kind kind) {
    return read.computeIfAbsent(kind, it -> new ProjectSchema(text(it)));
  }

  private static String text(Kind kind) {
    return switch (kind) {
      case MUTANTS, TESTS -> NOTHING;
      case SETTINGS -> Configuration.schema();
      case SUPPRESSIONS -> SuppressionFile.schema();
      case BENCH -> ProjectBench.schema();
      case SCENARIO -> ProjectBench.scenarioSchema();
      case FAULTS -> ProjectBench.faultsSchema();
      case CAMPAIGN -> Campaigns.schema();
    };
  }
}

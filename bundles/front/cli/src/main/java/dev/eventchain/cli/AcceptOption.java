package dev.eventchain.cli;

import dev.eventchain.pipeline.campaign.OpenScenarioCampaigns;
import dev.eventchain.pipeline.project.Project;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Option;

/** The option of what is required where a campaign is about a file in OpenSCENARIO XML. */
final class AcceptOption {

  @Option(
      names = "--accept",
      paramLabel = "CRITERION",
      description =
          "What is required if FILE is one in OpenSCENARIO XML (.xosc), whose parameters then vary"
              + " as its distributions or constraints say: a key of 'accept' in scenarios, such as"
              + " no_impact or maximal_impact_speed_kmh=10; may be repeated. The campaign file is"
              + " written to OUTPUT/openscenario.")
  private List<String> accept = List.of();

  /**
   * Returns the campaign file: the given one, or the one that is written about it.
   *
   * @param command the command with this option
   */
  Path campaign(ProjectCommand command, Project project, Path file) {
    return isPlayed(command, file)
        ? OpenScenarioCampaigns.write(file, accept, command.outputOf(project))
        : file;
  }

  /** As {@link #campaign}, for a search. */
  Path search(ProjectCommand command, Project project, Path file) {
    return isPlayed(command, file)
        ? OpenScenarioCampaigns.writeForSearch(file, accept, command.outputOf(project))
        : file;
  }

  private boolean isPlayed(ProjectCommand command, Path file) {
    boolean isPlayed = OpenScenarioCampaigns.isOne(file);
    if (!isPlayed && !accept.isEmpty()) {
      throw command.wrongUsage("--accept needs a file in OpenSCENARIO XML (.xosc)");
    }
    return isPlayed;
  }
}

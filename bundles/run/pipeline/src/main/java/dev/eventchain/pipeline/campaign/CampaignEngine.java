package dev.eventchain.pipeline.campaign;

import java.nio.file.Path;
import java.util.List;

/**
 * A Ray cluster on whose nodes a campaign is simulated.
 *
 * @param address as Ray understands it; empty for a cluster of this machine alone
 * @param options options of the command line that the parts of the campaign need, too
 * @param files the files that these options name, by their absolute paths
 */
public record CampaignEngine(String address, List<String> options, List<Path> files) {

  /** Placeholder of the folder of a node's copies of files, before their absolute paths. */
  public static final String FILES = "{files}";

  public CampaignEngine {
    options = List.copyOf(options);
    files = List.copyOf(files);
  }
}

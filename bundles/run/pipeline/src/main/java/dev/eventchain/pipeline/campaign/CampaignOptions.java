package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.plan.Shard;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * Options of a campaign.
 *
 * @param file the campaign file
 * @param only the only campaign of a file of several
 * @param dryRun whether cases are only counted, and a few of them timed
 * @param replayed the number of the only case that is simulated, from 1, as in the table
 * @param merged the folders of parts that are put together instead of simulating; usually none
 * @param engine what simulates instead of this machine
 * @param compared the folder of the results of another campaign
 */
public record CampaignOptions(
    Path file,
    Optional<String> only,
    boolean dryRun,
    Shard shard,
    OptionalInt replayed,
    List<Path> merged,
    Optional<CampaignEngine> engine,
    Optional<Path> compared) {

  /** Returns the options of all campaigns of a file, simulated here. */
  public static CampaignOptions of(Path file) {
    return new CampaignOptions(
        file,
        Optional.empty(),
        false,
        Shard.ALL,
        OptionalInt.empty(),
        List.of(),
        Optional.empty(),
        Optional.empty());
  }

  public CampaignOptions {
    merged = List.copyOf(merged);
  }

  /** Returns whether folders or numbers are given that can be those of one campaign only. */
  boolean needsOne() {
    return replayed.isPresent() || !merged.isEmpty() || compared.isPresent();
  }
}

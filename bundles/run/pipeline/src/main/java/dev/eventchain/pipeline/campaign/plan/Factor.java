package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;

/**
 * Something that differs between the cases of a campaign.
 *
 * @param name a word, for tables and conditions
 * @param paths the numbers of the scenario that have its value, such as {@code actors[0].gap_m}
 */
public record Factor(String name, List<String> paths, Levels levels, SourceLocation place) {

  public Factor {
    paths = List.copyOf(paths);
  }
}

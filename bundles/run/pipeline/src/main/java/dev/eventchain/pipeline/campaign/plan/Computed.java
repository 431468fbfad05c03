package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.scenario.NumberFormulas;
import java.util.List;

/**
 * A number that follows from the factors, and from what is computed before it.
 *
 * @param name a word, for the formulas after it
 * @param paths the numbers of the scenario that have its value; none if only formulas read it
 */
public record Computed(
    String name, List<String> paths, NumberFormulas.Quantity formula, SourceLocation place) {

  public Computed {
    paths = List.copyOf(paths);
  }
}

package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.SourceRange;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What a campaign file says.
 *
 * @param name that of its results
 * @param scenario the name of the scenario whose cases are simulated
 * @param conditions keep the combinations for which all are true
 * @param repetitions of each combination, with other seeds
 * @param seed of what is drawn
 */
record CampaignPlan(
    Path file,
    String name,
    String scenario,
    List<Factor> factors,
    Sampling sampling,
    List<SourceRange> conditions,
    int repetitions,
    long seed,
    Optional<Boundary> boundary) {

  /**
   * A search for the values at which the verdict flips.
   *
   * @param factor the number of the factor along which it is searched
   * @param resolution the largest distance of a value that passes from one that does not
   */
  record Boundary(int factor, BigDecimal resolution) {}

  CampaignPlan {
    factors = List.copyOf(factors);
    conditions = List.copyOf(conditions);
  }

  List<String> names() {
    return factors.stream().map(Factor::name).toList();
  }
}

package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Halves the distance between neighbouring values of a factor of which one passes and the other one
 * does not, in each combination of the other factors. A band between two values of the grid that
 * both pass is not seen.
 */
public final class BoundarySearch {

  private static final BigDecimal TWO = BigDecimal.valueOf(2);

  /** A flip: two neighbouring cases with different verdicts. */
  record Flip(CampaignRow before, CampaignRow after) {}

  private final int factor;
  private final BigDecimal resolution;

  public BoundarySearch(CampaignPlan.Boundary boundary) {
    this.factor = boundary.factor();
    this.resolution = boundary.resolution();
  }

  /** Returns the cases that have to be known next; none if all flips are narrow enough. */
  public List<CampaignCase> next(Collection<CampaignRow> rows) {
    List<CampaignCase> wanted = new ArrayList<>();
    for (Flip flip : flips(rows)) {
      BigDecimal low = flip.before().id().values().get(factor);
      BigDecimal high = flip.after().id().values().get(factor);
      if (high.subtract(low).compareTo(resolution) > 0) {
        wanted.add(flip.before().id().with(factor, low.add(high).divide(TWO)));
      }
    }
    return wanted;
  }

  /** Returns all flips, in the order of the other factors, and then of this one. */
  List<Flip> flips(Collection<CampaignRow> rows) {
    Map<CampaignCase, CampaignRow> latest = new LinkedHashMap<>();
    List<Flip> flips = new ArrayList<>();
    for (CampaignRow row : rows) {
      if (row.is(Label.ERROR)) {
        continue; // neither side of a boundary
      }
      CampaignRow before = latest.put(row.id().with(factor, BigDecimal.ZERO), row);
      if (before != null && before.is(Label.PASSED) != row.is(Label.PASSED)) {
        flips.add(new Flip(before, row));
      }
    }
    return flips;
  }
}

package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.SearchSettings;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Halves the distance between neighbouring values of a factor with different verdicts, or different
 * outcomes of one criterion, in each combination of the other factors. A band between two values of
 * the grid that both have the same verdict is not seen.
 */
public final class BoundarySearch {

  private static final BigDecimal TWO = BigDecimal.valueOf(2);

  /**
   * A flip: two neighbouring cases with different verdicts.
   *
   * @param isNarrow whether their distance is as small as it was to become; it stays larger where
   *     the case between them has no verdict, or is refused by a condition
   */
  record Flip(Side before, Side after, boolean isNarrow) {}

  /** A case with its verdict, or with the outcome of the criterion whose boundary it is. */
  record Side(CampaignRow row, Label label) {}

  /** The cases of a combination of the other factors that have a verdict, by this factor. */
  record Line(CampaignCase id, List<Side> sides, List<Flip> flips) {}

  private final int factor;
  private final BigDecimal resolution;
  private final Optional<String> criterion;

  public BoundarySearch(CampaignPlan.Boundary boundary) {
    this.factor = boundary.factor();
    this.resolution = boundary.resolution();
    this.criterion = boundary.criterion().map(SearchSettings.Named::text);
  }

  /** Returns the cases that have to be known next; none if all flips are narrow enough. */
  public List<CampaignCase> next(Collection<CampaignRow> rows) {
    return lines(rows).stream()
        .flatMap(line -> line.flips().stream())
        .filter(flip -> !flip.isNarrow())
        .map(
            flip ->
                flip.before()
                    .row()
                    .id()
                    .with(factor, value(flip.before()).add(value(flip.after())).divide(TWO)))
        .toList();
  }

  BigDecimal value(Side side) {
    return side.row().id().values().get(factor);
  }

  /** Returns the combinations of the other factors, each with its flips, in their order. */
  List<Line> lines(Collection<CampaignRow> rows) {
    Map<CampaignCase, List<Side>> sides = new LinkedHashMap<>();
    for (CampaignRow row : rows) {
      List<Side> own =
          sides.computeIfAbsent(row.id().with(factor, BigDecimal.ZERO), key -> new ArrayList<>());
      label(row).ifPresent(label -> own.add(new Side(row, label)));
    }
    return sides.entrySet().stream()
        .map(line -> new Line(line.getKey(), line.getValue(), flips(line.getValue())))
        .toList();
  }

  private List<Flip> flips(List<Side> sides) {
    List<Flip> flips = new ArrayList<>();
    for (int i = 1; i < sides.size(); i++) {
      Side before = sides.get(i - 1);
      Side after = sides.get(i);
      if (before.label() != after.label()) {
        BigDecimal distance = value(after).subtract(value(before));
        flips.add(new Flip(before, after, distance.compareTo(resolution) <= 0));
      }
    }
    return flips;
  }

  /** Returns the verdict of a case; none if it ended by an error, or has no such criterion. */
  private Optional<Label> label(CampaignRow row) {
    if (row.is(Label.ERROR)) {
      return Optional.empty(); // neither side of a boundary
    }
    if (criterion.isEmpty()) {
      return Optional.of(row.result().label());
    }
    return row.result().criteria().stream()
        .filter(each -> each.name().startsWith(criterion.get()))
        .map(CriterionMargin::label)
        .findFirst();
  }
}

package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.diagnostics.Trial;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;

/** A test for each combination of the factors besides that along which a boundary is searched. */
final class BoundaryTrials {

  private final CampaignPlan plan;
  private final int factor;
  private final List<CampaignRow> rows;

  BoundaryTrials(CampaignPlan plan, CampaignPlan.Boundary boundary, List<CampaignRow> rows) {
    this.plan = plan;
    this.factor = boundary.factor();
    this.rows = rows;
  }

  List<Trial> of(List<BoundarySearch.Line> lines) {
    return lines.stream().map(this::of).toList();
  }

  private Trial of(BoundarySearch.Line line) {
    List<CampaignRow> own =
        rows.stream()
            .filter(row -> row.id().with(factor, BigDecimal.ZERO).equals(line.id()))
            .toList();
    String others = line.id().wordsWithout(factor, plan);
    String name = others.isEmpty() ? "" : ": " + others;
    return new Trial(
        Trial.Kind.CASE,
        plan.name() + name + ", along " + plan.names().get(factor),
        outcome(own),
        words(line),
        own.stream().mapToDouble(row -> row.result().end()).sum(),
        List.of());
  }

  /**
   * Returns an outcome as the findings of the campaign have it: cases are to fail on one side, and
   * where none passes, that is no pass, but an error only if it is so everywhere.
   */
  private Trial.Outcome outcome(List<CampaignRow> own) {
    if (own.stream().anyMatch(row -> row.is(Label.ERROR) || row.is(Label.UNTESTED))) {
      return Trial.Outcome.FAILED;
    }
    if (own.stream().anyMatch(row -> row.is(Label.PASSED))) {
      return Trial.Outcome.PASSED;
    }
    boolean somePass = rows.stream().anyMatch(row -> row.is(Label.PASSED));
    return somePass ? Trial.Outcome.SKIPPED : Trial.Outcome.FAILED;
  }

  private String words(BoundarySearch.Line line) {
    return line.flips().isEmpty()
        ? "no flip: " + BoundaryWords.throughout(line)
        : line.flips().stream()
            .map(flip -> side(flip.before(), " up to ") + ", " + side(flip.after(), " from "))
            .collect(Collectors.joining("; "));
  }

  private String side(BoundarySearch.Side side, String words) {
    String value = side.row().id().values().get(factor).toPlainString();
    return CampaignRow.words(side.label()) + words + value;
  }
}

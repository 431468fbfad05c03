package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.Points.Score;
import dev.eventchain.pipeline.results.ResultJson;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The points of the cases of a campaign, as a protocol counts them.
 *
 * @param source the protocol, with its version
 * @param scores in the order of the cases
 */
public record CampaignPoints(String source, List<Score> scores) {

  public CampaignPoints {
    scores = List.copyOf(scores);
  }

  /** Returns the points of cases; empty if the campaign counts none. */
  public static Optional<CampaignPoints> of(CampaignPlan plan, List<CampaignRow> rows) {
    return plan.points()
        .map(
            points ->
                new CampaignPoints(
                    points.source(),
                    rows.stream()
                        .map(row -> plan.score(row.id(), row.result()).orElseThrow())
                        .toList()));
  }

  double sum() {
    return scores.stream().mapToDouble(each -> each.points().orElse(0.0)).sum();
  }

  double most() {
    return scores.stream().mapToDouble(Score::most).sum();
  }

  /** Returns the number of cases that were not tested, or ended by an error. */
  private long without() {
    return scores.stream().filter(each -> each.isCounted() && each.points().isEmpty()).count();
  }

  /** Returns the number of cases that the protocol does not have. */
  private long others() {
    return scores.stream().filter(each -> !each.isCounted()).count();
  }

  /** Returns the sum of all, such as "12.5 of 14". */
  public String total() {
    return number(sum()) + " of " + number(most());
  }

  /** Returns what people have to know about the sum. */
  public String note() {
    String note = source;
    if (without() > 0) {
      note += "; none for " + Coverage.counted(without(), "case") + " without a verdict";
    }
    return others() == 0
        ? note
        : note + "; none for " + Coverage.counted(others(), "case") + " that it does not have";
  }

  /** Returns the points of a case, such as "0.5"; "-" if it has none. */
  String of(int index) {
    OptionalDouble points = scores.get(index).points();
    return points.isPresent() ? number(points.getAsDouble()) : "-";
  }

  /** Returns the points of a case beside those that it may have, such as "0.5 of 2". */
  String ofMost(int index) {
    return scores.get(index).isCounted()
        ? of(index) + " of " + number(scores.get(index).most())
        : "none, since the protocol does not have this case";
  }

  /** Returns the points of a case with their protocol, such as "points: 0.5 of 2 (Protocol 1)". */
  String words(int index) {
    return "points: " + ofMost(index) + " (" + source + ")";
  }

  /** Returns the points of a case as a report for tools names them; none if it has none. */
  Map<String, String> figures(int index) {
    Score score = scores.get(index);
    Map<String, String> figures = new LinkedHashMap<>();
    if (score.points().isPresent()) {
      figures.put("points", number(score.points().getAsDouble()));
      figures.put("most_points", number(score.most()));
      figures.put("points_source", source);
    }
    return figures;
  }

  /** Adds the columns of points. */
  public CampaignTable in(CampaignTable table) {
    List<String> points = new ArrayList<>();
    List<String> most = new ArrayList<>();
    for (Score each : scores) {
      points.add(each.points().isPresent() ? number(each.points().getAsDouble()) : "");
      most.add(each.isCounted() ? number(each.most()) : "");
    }
    return table.with("points", points).with("most_points", most);
  }

  /** A case in JSON. */
  private record Case(
      int number,
      Map<String, BigDecimal> values,
      String verdict,
      OptionalDouble points,
      OptionalDouble most) {}

  /** All of them in JSON. */
  private record Written(
      String campaign, String source, double points, double most, List<Case> cases) {}

  public byte[] json(CampaignPlan plan, List<CampaignRow> rows) {
    List<Case> cases = new ArrayList<>();
    for (int i = 0; i < rows.size(); i++) {
      Map<String, BigDecimal> values = new LinkedHashMap<>();
      for (int factor = 0; factor < plan.factors().size(); factor++) {
        values.put(plan.names().get(factor), rows.get(i).id().values().get(factor));
      }
      Score score = scores.get(i);
      String verdict = rows.get(i).word();
      OptionalDouble most =
          score.isCounted() ? OptionalDouble.of(score.most()) : OptionalDouble.empty();
      cases.add(new Case(i + 1, values, verdict, score.points(), most));
    }
    return ResultJson.bytes(new Written(plan.name(), source, sum(), most(), cases));
  }

  /** Returns a number with two digits behind the point at most. */
  private static String number(double value) {
    return BigDecimal.valueOf(value)
        .setScale(2, RoundingMode.HALF_UP)
        .stripTrailingZeros()
        .toPlainString();
  }
}

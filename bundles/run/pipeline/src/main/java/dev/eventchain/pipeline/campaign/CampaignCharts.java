package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.report.StaticPage;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;

/** The pictures of a campaign's page: cases over two factors, and how margins are distributed. */
final class CampaignCharts {

  static final String STYLE =
      """
      .charts { display: flex; flex-wrap: wrap; align-items: end; gap: 1.2rem 2rem; }
      .charts figure { margin: 0; width: 21rem; }
      .charts figcaption { font-size: .85rem; }
      .chart { display: block; width: 100%; height: auto; max-width: 46rem; }
      .chart text { font-size: 11px; fill: currentColor; }
      .chart line { stroke: currentColor; stroke-opacity: .25; }
      .chart .zero { stroke-opacity: .9; }
      .chart .passed { fill: #2e7d4f; }
      .chart .failed { fill: #b3362e; }
      .chart .untested { fill: none; stroke: #888; }
      .chart .error { fill: #d9a441; }
      """;

  private static final int BINS = 16;
  private static final int TICKS = 6;
  private static final double ROUNDING = 1e-5;

  private final StaticPage page;
  private final List<CampaignRow> rows;

  CampaignCharts(StaticPage page, List<CampaignRow> rows) {
    this.page = page;
    this.rows = rows;
  }

  /** Adds a point for each case. */
  void points(int down, int across, List<String> names) {
    ChartAxis x = axis(across);
    ChartAxis y = axis(down);
    page.add(
        "<svg class=\"chart\" viewBox=\"0 0 720 420\" role=\"img\" aria-label=\"Cases over %s and"
            + " %s\">\n",
        names.get(across), names.get(down));
    for (BigDecimal tick : x.ticks()) {
      double at = 60 + 640 * x.share(tick.doubleValue());
      line(at, 20, at, 370, "");
      text(at, 388, "middle", ChartAxis.text(tick));
    }
    for (BigDecimal tick : y.ticks()) {
      double at = 370 - 350 * y.share(tick.doubleValue());
      line(60, at, 700, at, "");
      text(52, at + 4, "end", ChartAxis.text(tick));
    }
    text(700, 410, "end", names.get(across));
    text(4, 12, "start", names.get(down));
    // What did not pass lies above what did.
    rows.stream()
        .sorted(Comparator.comparing(row -> !row.is(Label.PASSED)))
        .forEach(row -> point(row, x.share(value(row, across)), y.share(value(row, down))));
    page.raw("</svg>\n");
  }

  private void point(CampaignRow row, double across, double up) {
    page.add(
        "<circle class=\"%s\" cx=\"%s\" cy=\"%s\" r=\"4\"><title>%s</title></circle>\n",
        row.result().label().name().toLowerCase(Locale.ROOT),
        number(60 + 640 * across),
        number(370 - 350 * up),
        "case " + (rows.indexOf(row) + 1));
  }

  private ChartAxis axis(int factor) {
    double[] values = rows.stream().mapToDouble(row -> value(row, factor)).sorted().toArray();
    return ChartAxis.of(values[0], values[values.length - 1], TICKS);
  }

  private static double value(CampaignRow row, int factor) {
    return row.id().values().get(factor).doubleValue();
  }

  /** Adds, for each criterion whose margins differ, how many cases have which. */
  void margins() {
    Map<String, List<CriterionMargin>> byCriterion = new LinkedHashMap<>();
    for (CampaignRow row : rows) {
      for (CriterionMargin each : row.result().criteria()) {
        if (each.margin().isPresent()) {
          byCriterion
              .computeIfAbsent(each.name() + "\n" + each.unit(), key -> new ArrayList<>())
              .add(each);
        }
      }
    }
    byCriterion.values().removeIf(all -> !differ(all));
    if (byCriterion.isEmpty()) {
      return;
    }
    page.raw(
        "<section><h2>Margins</h2>\n<p class=\"muted\">How many cases have which margin; what is");
    page.raw(" below 0 failed. Criteria whose margin is the same in all cases are left out.</p>\n");
    page.raw("<div class=\"charts\">\n");
    byCriterion.values().forEach(this::histogram);
    page.raw("</div></section>\n");
  }

  /** Returns whether margins differ by more than rounding does. */
  private static boolean differ(List<CriterionMargin> all) {
    DoubleSummaryStatistics margins =
        all.stream().mapToDouble(each -> each.margin().orElseThrow()).summaryStatistics();
    double size = Math.max(Math.abs(margins.getMin()), Math.abs(margins.getMax()));
    return margins.getMax() - margins.getMin() > ROUNDING * size;
  }

  private void histogram(List<CriterionMargin> all) {
    double[] sorted =
        all.stream().mapToDouble(each -> each.margin().orElseThrow()).sorted().toArray();
    ChartAxis axis = ChartAxis.of(sorted[0], sorted[sorted.length - 1], BINS);
    int[] counts = new int[axis.count()];
    for (double margin : sorted) {
      counts[axis.bin(margin)]++;
    }
    int most = IntStream.of(counts).max().orElseThrow();
    String unit = all.get(0).unit().equals("1") ? "" : " " + all.get(0).unit();
    page.add("<figure><figcaption>%s</figcaption>\n", all.get(0).name());
    page.raw("<svg class=\"chart\" viewBox=\"0 0 336 130\" role=\"img\">\n");
    page.add(
        "<title>%s</title>\n",
        "margins of %d cases: from %.4g to %.4g%s, half of them up to %.4g%s"
            .formatted(
                sorted.length,
                sorted[0],
                sorted[sorted.length - 1],
                unit,
                sorted[(sorted.length - 1) / 2],
                unit));
    List<BigDecimal> ticks = axis.ticks();
    for (int i = 0; i < counts.length; i++) {
      bar(axis, ticks, i, 90.0 * counts[i] / most, counts[i]);
    }
    scale(axis, unit);
    page.raw("</svg></figure>\n");
  }

  private void scale(ChartAxis axis, String unit) {
    List<BigDecimal> ticks = axis.ticks();
    line(8, 105, 328, 105, "");
    if (axis.first().signum() < 0 && ticks.get(axis.count()).signum() > 0) {
      double zero = 8 + 320 * axis.share(0);
      line(zero, 8, zero, 110, "zero");
      text(zero, 124, "middle", "0");
    }
    text(8, 124, "start", ChartAxis.text(ticks.get(0)) + unit);
    text(328, 124, "end", ChartAxis.text(ticks.get(axis.count())) + unit);
  }

  private void bar(ChartAxis axis, List<BigDecimal> ticks, int bin, double height, int count) {
    if (count > 0) {
      page.add(
          "<rect class=\"%s\" x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\"><title>%s</title></rect>\n",
          ticks.get(bin).signum() < 0 ? "failed" : "passed",
          number(8 + 320.0 * bin / axis.count() + 0.5),
          number(105 - height),
          number(320.0 / axis.count() - 1),
          number(height),
          "%d from %s to %s"
              .formatted(
                  count, ChartAxis.text(ticks.get(bin)), ChartAxis.text(ticks.get(bin + 1))));
    }
  }

  private void line(double x1, double y1, double x2, double y2, String kind) {
    page.add(
        "<line class=\"%s\" x1=\"%s\" y1=\"%s\" x2=\"%s\" y2=\"%s\"/>\n",
        kind, number(x1), number(y1), number(x2), number(y2));
  }

  private void text(double x, double y, String anchor, String text) {
    page.add(
        "<text x=\"%s\" y=\"%s\" text-anchor=\"%s\">%s</text>\n",
        number(x), number(y), anchor, text);
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.1f", value);
  }
}

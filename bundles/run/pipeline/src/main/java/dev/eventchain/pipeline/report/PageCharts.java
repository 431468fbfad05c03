package dev.eventchain.pipeline.report;

import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Charts of a page, in SVG: points over two quantities, and how values are distributed. */
public final class PageCharts {

  /** The style of the charts. */
  public static final String STYLE =
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

  /**
   * A point.
   *
   * @param kind its class in the style: passed, failed, untested or error
   * @param title what is said of it where the mouse is
   */
  public record Point(double across, double up, String kind, String title) {}

  private final StaticPage page;

  public PageCharts(StaticPage page) {
    this.page = page;
  }

  /**
   * Adds points, of which later ones lie above earlier ones.
   *
   * @param points at least one
   */
  public void points(String across, String up, List<Point> points) {
    ChartAxis x = axis(points.stream().mapToDouble(Point::across), TICKS);
    ChartAxis y = axis(points.stream().mapToDouble(Point::up), TICKS);
    page.add(
        "<svg class=\"chart\" viewBox=\"0 0 720 420\" role=\"img\" aria-label=\"%s over %s\">\n",
        up, across);
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
    text(700, 410, "end", across);
    text(4, 12, "start", up);
    points.forEach(each -> point(each, x.share(each.across()), y.share(each.up())));
    page.raw("</svg>\n");
  }

  private void point(Point point, double across, double up) {
    page.add(
        "<circle class=\"%s\" cx=\"%s\" cy=\"%s\" r=\"4\"><title>%s</title></circle>\n",
        point.kind(), number(60 + 640 * across), number(370 - 350 * up), point.title());
  }

  private static ChartAxis axis(DoubleStream values, int steps) {
    double[] sorted = values.sorted().toArray();
    return ChartAxis.of(sorted[0], sorted[sorted.length - 1], steps);
  }

  /**
   * Adds a figure with how many values lie where; those below 0 as failed.
   *
   * @param unit with a space before it; empty for plain numbers
   * @param values at least one
   */
  public void histogram(String title, String unit, double[] values) {
    double[] sorted = DoubleStream.of(values).sorted().toArray();
    ChartAxis axis = axis(DoubleStream.of(values), BINS);
    int[] counts = new int[axis.count()];
    for (double value : sorted) {
      counts[axis.bin(value)]++;
    }
    int most = IntStream.of(counts).max().orElseThrow();
    page.add("<figure><figcaption>%s</figcaption>\n", title);
    page.raw("<svg class=\"chart\" viewBox=\"0 0 336 130\" role=\"img\">\n");
    page.add("<title>%s</title>\n", summary(sorted, unit));
    List<BigDecimal> ticks = axis.ticks();
    for (int i = 0; i < counts.length; i++) {
      bar(axis, ticks, i, 90.0 * counts[i] / most, counts[i]);
    }
    scale(axis, unit);
    page.raw("</svg></figure>\n");
  }

  private static String summary(double[] sorted, String unit) {
    return String.format(
        Locale.ROOT,
        "%d values: from %.4g to %.4g%s, half of them up to %.4g%s",
        sorted.length,
        sorted[0],
        sorted[sorted.length - 1],
        unit,
        sorted[(sorted.length - 1) / 2],
        unit);
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
          String.format(
              Locale.ROOT,
              "%d from %s to %s",
              count,
              ChartAxis.text(ticks.get(bin)),
              ChartAxis.text(ticks.get(bin + 1))));
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

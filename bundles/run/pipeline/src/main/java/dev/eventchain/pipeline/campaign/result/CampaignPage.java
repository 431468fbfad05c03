package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.Shard;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.report.PageCharts;
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
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** The results of a campaign as one HTML file without scripts. */
public final class CampaignPage {

  private static final int NEAREST = 10;
  private static final int NEAREST_OF_ONE = 3;
  private static final double ROUNDING = 1e-5;

  /** The largest number of values of a factor that a table shows. */
  private static final int WIDEST = 60;

  private static final String STYLE =
      """

      .passed { background: #2e7d4f; color: #fff; }
      .passed.spared { background: #9cc9ab; }
      .failed { background: #b3362e; color: #fff; }
      .mixed { background: #d9a441; color: #000; }
      .untested { background: repeating-linear-gradient(45deg, #888 0 3px, #bbb 3px 6px); }
      """
          + CampaignMap.STYLE
          + PageCharts.STYLE;

  private final Project project;
  private final CampaignPlan plan;
  private final Shard shard;
  private final List<CampaignRow> rows;
  private final CampaignSummary summary;
  private final Optional<CampaignPoints> points;
  private final StaticPage page;
  private final PageCharts charts;

  private CampaignPage(Project project, CampaignPlan plan, Shard shard, List<CampaignRow> rows) {
    this.shard = shard;
    this.project = project;
    this.plan = plan;
    this.rows = rows;
    this.summary = new CampaignSummary(plan, rows);
    this.points = CampaignPoints.of(plan, rows);
    this.page = new StaticPage("Campaign " + plan.name(), STYLE);
    this.charts = new PageCharts(page);
  }

  public static String of(
      Project project,
      CampaignPlan plan,
      Shard shard,
      List<CampaignRow> rows,
      Optional<CampaignComparison> comparison) {
    CampaignPage page = new CampaignPage(project, plan, shard, rows);
    page.head();
    page.figures();
    page.factors();
    page.boundary();
    comparison.ifPresent(page::changes);
    page.failures();
    page.margins();
    page.nearest();
    return page.page.end("All cases are in " + CampaignStore.TABLE + ".");
  }

  private void head() {
    add("<p class=\"kicker\">Eventchain campaign · %s</p>\n", project.configuration().name());
    add("<h1>%s: cases of %s</h1>\n", plan.name(), plan.scenario());
  }

  private void figures() {
    raw("<dl class=\"figures\">");
    figure("Cases", rows.size());
    figure("Passed", summary.count(Label.PASSED));
    figure("Failed", summary.count(Label.FAILED));
    figure("Not tested", summary.count(Label.UNTESTED));
    figure("Ended by an error", summary.count(Label.ERROR));
    points.ifPresent(it -> figure("Points", it.total()));
    raw("</dl>\n");
    points.ifPresent(it -> add("<p class=\"muted\">Points: %s.</p>\n", it.note()));
    if (!summary.ofNothingAhead().isEmpty()) {
      add("<p>%s.</p>\n", summary.ofNothingAhead());
    }
  }

  private void figure(String name, Object value) {
    add("<div><dt>%s</dt><dd>%s</dd></div>", name, value);
  }

  /** Adds the cases over the first two factors that differ: points where values are drawn. */
  private void factors() {
    int[] shown =
        IntStream.range(0, plan.factors().size())
            .filter(i -> values(i).size() > 1)
            .filter(i -> isDrawn(i) || values(i).size() <= WIDEST)
            .limit(2)
            .toArray();
    if (shown.length < 2) {
      return;
    }
    add("<section><h2>%s and %s</h2>\n", plan.names().get(shown[0]), plan.names().get(shown[1]));
    if (isDrawn(shown[0]) || isDrawn(shown[1])) {
      points(shown[0], shown[1]);
    } else {
      new CampaignMap(plan, rows, points, shown[0], shown[1], page)
          .add(values(shown[0]), values(shown[1]));
    }
    raw("</section>\n");
  }

  private boolean isDrawn(int factor) {
    return plan.factors().get(factor).levels().isContinuous();
  }

  /** Adds a point for each case; what did not pass lies above what did. */
  private void points(int up, int across) {
    charts.points(
        plan.names().get(across),
        plan.names().get(up),
        IntStream.range(0, rows.size())
            .boxed()
            .sorted(Comparator.comparing(number -> !rows.get(number).is(Label.PASSED)))
            .map(number -> point(number, across, up))
            .toList());
  }

  private PageCharts.Point point(int number, int across, int up) {
    CampaignRow row = rows.get(number);
    List<BigDecimal> values = row.id().values();
    return new PageCharts.Point(
        values.get(across).doubleValue(),
        values.get(up).doubleValue(),
        row.result().label().name().toLowerCase(Locale.ROOT),
        "case " + (number + 1));
  }

  private List<BigDecimal> values(int factor) {
    TreeSet<BigDecimal> values = new TreeSet<>();
    rows.forEach(row -> values.add(row.id().values().get(factor)));
    if (plan.boundary().filter(it -> it.factor() == factor).isPresent()) {
      // Without those that were added on the way to the boundary.
      values.retainAll(new TreeSet<>(plan.factors().get(factor).levels().checked()));
    }
    return new ArrayList<>(values);
  }

  private void boundary() {
    summary.boundary().ifPresent(it -> boundary(it, plan.boundary().orElseThrow().factor()));
  }

  private void boundary(BoundaryWords words, int factor) {
    add("<section><h2>Boundary along %s</h2>\n<p>%s. ", words.factor(), words.flips());
    raw("A band of another verdict between two neighbouring values is not seen.</p>\n");
    List<BoundarySearch.Flip> flips = words.all();
    if (!flips.isEmpty()) {
      raw("<div class=\"scroll\"><table><thead><tr><th>The other factors</th><th>up to</th>");
      raw("<th></th><th>from</th><th></th></tr></thead><tbody>\n");
      flips.forEach(flip -> flip(flip, factor));
      raw("</tbody></table></div>\n");
    }
    if (!words.quiet().isEmpty()) {
      String rest = words.rest();
      add("<p>%s%s.</p>\n", rest.substring(0, 1).toUpperCase(Locale.ROOT), rest.substring(1));
      raw("<div class=\"scroll\"><table><thead><tr><th>The other factors</th><th>from</th>");
      raw("<th>to</th><th></th></tr></thead><tbody>\n");
      words.quiet().forEach(line -> line(line, factor));
      raw("</tbody></table></div>\n");
    }
    raw("</section>\n");
  }

  private void flip(BoundarySearch.Flip flip, int factor) {
    add("<tr><td>%s</td>", flip.before().row().id().wordsWithout(factor, plan));
    for (BoundarySearch.Side side : List.of(flip.before(), flip.after())) {
      add("<td>%s</td>", value(side, factor));
      add("<td>%s</td>", CampaignRow.words(side.label()));
    }
    raw(flip.isNarrow() ? "</tr>\n" : "<td>no case between has a verdict</td></tr>\n");
  }

  private void line(BoundarySearch.Line line, int factor) {
    List<BoundarySearch.Side> sides = line.sides();
    add("<tr><td>%s</td>", line.id().wordsWithout(factor, plan));
    add("<td>%s</td>", sides.isEmpty() ? "" : value(sides.get(0), factor));
    add("<td>%s</td>", sides.isEmpty() ? "" : value(sides.get(sides.size() - 1), factor));
    add("<td>%s</td></tr>\n", BoundaryWords.throughout(line));
  }

  private static String value(BoundarySearch.Side side, int factor) {
    return side.row().id().values().get(factor).toPlainString();
  }

  private void changes(CampaignComparison comparison) {
    raw("<section><h2>Compared with another campaign</h2>\n");
    add("<p>%s.</p>\n", comparison.text().strip());
    for (boolean better : new boolean[] {false, true}) {
      List<CampaignRow> rowsNow =
          comparison.changes(better).stream()
              .map(CampaignComparison.Change::now)
              .limit(NEAREST)
              .toList();
      if (!rowsNow.isEmpty()) {
        raw(better ? "<h3>Pass now</h3>\n" : "<h3>No longer pass</h3>\n");
        table(rowsNow);
      }
    }
    raw("</section>\n");
  }

  /** Returns whether the margins of the criterion, in its unit, differ between the cases. */
  private boolean differs(CriterionMargin margin) {
    List<CriterionMargin> all =
        rows.stream()
            .flatMap(row -> row.result().criteria().stream())
            .filter(each -> each.name().equals(margin.name()))
            .filter(each -> each.unit().equals(margin.unit()) && each.margin().isPresent())
            .toList();
    return differ(values(all));
  }

  /** Adds, for each criterion whose margins differ, how many cases have which. */
  private void margins() {
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
    byCriterion.values().removeIf(all -> !differ(values(all)));
    if (byCriterion.isEmpty()) {
      return;
    }
    raw("<section><h2>Margins</h2>\n<p class=\"muted\">How many cases have which margin; what is");
    raw(" below 0 failed. Criteria whose margin is the same in all cases are left out.</p>\n");
    raw("<div class=\"charts\">\n");
    byCriterion
        .values()
        .forEach(all -> charts.histogram(all.get(0).name(), unit(all.get(0)), values(all)));
    raw("</div></section>\n");
  }

  private static double[] values(List<CriterionMargin> margins) {
    return margins.stream().mapToDouble(each -> each.margin().orElseThrow()).toArray();
  }

  /** Returns whether values differ by more than rounding does. */
  private static boolean differ(double[] values) {
    DoubleSummaryStatistics all = DoubleStream.of(values).summaryStatistics();
    double size = Math.max(Math.abs(all.getMin()), Math.abs(all.getMax()));
    return all.getMax() - all.getMin() > ROUNDING * size;
  }

  private void nearest() {
    List<CampaignSummary.Near> nearest =
        summary.nearest(NEAREST_OF_ONE).stream().filter(near -> differs(near.margin())).toList();
    if (nearest.isEmpty()) {
      return;
    }
    raw("<section><h2>Passed, but nearest to failing</h2>\n");
    raw("<div class=\"scroll\"><table><thead><tr><th>Criterion</th><th>Margin</th>");
    raw("<th>Case</th><th>Values</th><th>Once more</th></tr></thead><tbody>\n");
    for (CampaignSummary.Near near : nearest) {
      int number = rows.indexOf(near.row()) + 1;
      add("<tr><td>%s</td><td>%s</td>", near.margin().name(), margin(near.margin()));
      add("<td>%s</td><td>%s</td>", number, near.row().id().words(plan));
      onceMore(number);
    }
    raw("</tbody></table></div></section>\n");
  }

  public static String margin(CriterionMargin margin) {
    return String.format(Locale.ROOT, "%.3g%s", margin.margin().orElseThrow(), unit(margin));
  }

  private static String unit(CriterionMargin margin) {
    return margin.unit().equals("1") ? "" : " " + margin.unit();
  }

  private void onceMore(int number) {
    String only = plan.part().map(name -> " --only " + name).orElse("");
    String part = shard.coversAll() ? "" : " --shard " + shard.number() + "/" + shard.count();
    add(
        "<td><code>eventchain campaign DIR %s%s%s --case %s</code></td></tr>\n",
        plan.file(), only, part, number);
  }

  private void failures() {
    List<CampaignRow> failed = rows.stream().filter(row -> !row.is(Label.PASSED)).toList();
    if (!failed.isEmpty()) {
      boolean all = failed.size() <= NEAREST;
      add("<section><h2>%s</h2>\n", all ? "Did not pass" : "The first that did not pass");
      table(failed.subList(0, all ? failed.size() : NEAREST));
      raw("</section>\n");
    }
  }

  private void table(List<CampaignRow> shown) {
    raw("<div class=\"scroll\"><table><thead><tr><th>Case</th><th>Values</th><th>Verdict</th>");
    raw("<th>Reason</th><th>Once more</th></tr></thead><tbody>\n");
    for (CampaignRow row : shown) {
      int number = rows.indexOf(row) + 1;
      add("<tr><td>%s</td><td>%s</td>", number, row.id().words(plan));
      add("<td>%s</td><td>%s</td>", word(row), row.result().reason());
      onceMore(number);
    }
    raw("</tbody></table></div>\n");
  }

  private static String word(CampaignRow row) {
    return CampaignRow.words(row.result().label());
  }

  private void raw(String html) {
    page.raw(html);
  }

  private void add(String html, Object... texts) {
    page.add(html, texts);
  }
}

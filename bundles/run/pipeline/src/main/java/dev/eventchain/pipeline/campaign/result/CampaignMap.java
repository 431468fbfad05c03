package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.report.StaticPage;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The cases of a campaign over the values of two factors, as a table with colours. */
final class CampaignMap {

  static final String STYLE =
      """

      .map { width: auto; border-collapse: collapse; font-variant-numeric: tabular-nums; }
      .map td { width: 1.6rem; height: 1.4rem; border: 1px solid Canvas; padding: 0; text-align: center; font-size: .7rem; }
      .map th { font-weight: normal; padding: 0 .4rem; text-align: right; white-space: nowrap; }
      .map thead th { text-align: center; }
      .map thead th:first-child { text-align: right; }
      .map td.flips-left { border-left: 3px solid CanvasText; }
      .map td.flips-top { border-top: 3px solid CanvasText; }
      """;

  private final CampaignPlan plan;
  private final List<CampaignRow> rows;
  private final Optional<CampaignPoints> points;
  private final int down;
  private final int right;
  private final StaticPage page;

  /**
   * Creates a map.
   *
   * @param down the number of the factor whose values are the rows
   * @param right that of the one whose values are the columns
   */
  CampaignMap(
      CampaignPlan plan,
      List<CampaignRow> rows,
      Optional<CampaignPoints> points,
      int down,
      int right,
      StaticPage page) {
    this.plan = plan;
    this.rows = rows;
    this.points = points;
    this.down = down;
    this.right = right;
    this.page = page;
  }

  /** Adds the map with its legend to the page. */
  void add(List<BigDecimal> rowValues, List<BigDecimal> columnValues) {
    legend();
    page.raw("<div class=\"scroll\"><table class=\"map\"><thead><tr>");
    List<String> names = plan.names();
    page.add("<th>%s ↓ %s →</th>", names.get(down), names.get(right));
    columnValues.forEach(value -> page.add("<th>%s</th>", value.toPlainString()));
    page.raw("</tr></thead><tbody>\n");
    List<CampaignRow> none = List.of();
    for (int i = 0; i < rowValues.size(); i++) {
      page.add("<tr><th>%s</th>", rowValues.get(i).toPlainString());
      for (int j = 0; j < columnValues.size(); j++) {
        List<CampaignRow> own = cases(rowValues.get(i), columnValues.get(j));
        List<CampaignRow> left = j == 0 ? none : cases(rowValues.get(i), columnValues.get(j - 1));
        List<CampaignRow> above = i == 0 ? none : cases(rowValues.get(i - 1), columnValues.get(j));
        cell(own, line(own, left, right, " flips-left") + line(own, above, down, " flips-top"));
      }
      page.raw("</tr>\n");
    }
    page.raw("</tbody></table></div>\n");
  }

  private void legend() {
    page.raw("<p class=\"muted\">Each cell has the cases that did not pass, of all with these");
    page.raw(
        " values; the others differ in the other factors. Green passed, red did not, yellow in");
    page.raw(" part, and what is hatched was not tested.");
    boolean spared = rows.stream().anyMatch(row -> row.result().nothingAhead());
    page.raw(spared ? " Nothing was ahead in what is a lighter green." : "");
    page.raw(flipsAlong(down) || flipsAlong(right) ? " The line is the boundary." : "");
    page.raw(points.isPresent() ? " A cell of one case has its points.</p>\n" : "</p>\n");
  }

  private boolean flipsAlong(int factor) {
    return plan.boundary()
        .filter(it -> it.factor() == factor && it.criterion().isEmpty())
        .isPresent();
  }

  private List<CampaignRow> cases(BigDecimal row, BigDecimal column) {
    return rows.stream()
        .filter(each -> each.id().values().get(down).compareTo(row) == 0)
        .filter(each -> each.id().values().get(right).compareTo(column) == 0)
        .toList();
  }

  /** Returns the class of a cell that differs from its neighbour along the boundary's factor. */
  private String line(List<CampaignRow> own, List<CampaignRow> before, int factor, String line) {
    boolean differs = !own.isEmpty() && !before.isEmpty() && !kind(own).equals(kind(before));
    return differs && flipsAlong(factor) ? line : "";
  }

  private static String kind(List<CampaignRow> cases) {
    long passed = cases.stream().filter(row -> row.is(Label.PASSED)).count();
    long untested = cases.stream().filter(row -> row.is(Label.UNTESTED)).count();
    if (passed == cases.size()) {
      return "passed";
    }
    return untested == cases.size() ? "untested" : passed + untested == 0 ? "failed" : "mixed";
  }

  private void cell(List<CampaignRow> cases, String line) {
    if (cases.isEmpty()) {
      page.raw("<td></td>");
      return;
    }
    boolean spared = cases.stream().allMatch(row -> row.result().nothingAhead());
    String kind = kind(cases) + (spared ? " spared" : "") + line;
    if (cases.size() == 1) {
      CampaignRow only = cases.get(0);
      int index = rows.indexOf(only);
      String title = points.map(it -> ", points: " + it.ofMost(index)).orElse("");
      page.add("<td class=\"%s\" title=\"%s%s\">", kind, only.words(), title);
      page.add("%s</td>", points.map(it -> it.of(index)).orElse(""));
      return;
    }
    long others = cases.stream().filter(row -> !row.is(Label.PASSED)).count();
    String words = String.format(Locale.ROOT, "%d of %d did not pass", others, cases.size());
    page.add("<td class=\"%s\" title=\"%s\">", kind, spared ? "nothing was ahead" : words);
    page.add("%s</td>", others == 0 ? "" : Long.toString(others));
  }
}

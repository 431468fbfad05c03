package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * The cases of a campaign as a table for the terminal. The first factor's values are the rows, and
 * those of a second one the columns; cells have the points of a case, if there are any. Other
 * campaigns have no such table.
 */
public final class CampaignMatrix {

  /** The most columns, so that a line fits into a terminal. */
  private static final int WIDEST = 8;

  private static final int TALLEST = 30;

  private static final Map<Label, String> WORDS =
      Map.of(
          Label.PASSED, "passed",
          Label.FAILED, "FAILED",
          Label.UNTESTED, "untested",
          Label.ERROR, "ERROR");

  private CampaignMatrix() {}

  /** Returns the table; empty if the cases do not fit into one. */
  static String of(CampaignPlan plan, List<CampaignRow> rows, Optional<CampaignPoints> points) {
    int factors = plan.factors().size();
    if (factors > 2 || plan.repetitions() > 1 || plan.boundary().isPresent() || rows.isEmpty()) {
      return "";
    }
    // Nearly each value that is drawn is one of its own, so that nearly all cells would be empty.
    if (factors > 1 && plan.factors().stream().anyMatch(it -> it.levels().isContinuous())) {
      return "";
    }
    Set<BigDecimal> lines = new TreeSet<>();
    Set<BigDecimal> columns = new TreeSet<>();
    Map<List<BigDecimal>, String> words = new TreeMap<>((a, b) -> compared(a, b));
    for (int i = 0; i < rows.size(); i++) {
      CampaignRow row = rows.get(i);
      int number = i;
      List<BigDecimal> values = row.id().values();
      lines.add(values.get(0));
      if (factors == 2) {
        columns.add(values.get(1));
      }
      words.put(
          values,
          WORDS.get(row.result().label()) + points.map(it -> " " + it.of(number)).orElse(""));
    }
    return lines.size() <= TALLEST && columns.size() <= WIDEST
        ? table(plan.names(), lines, columns, words)
        : "";
  }

  private static int compared(List<BigDecimal> one, List<BigDecimal> other) {
    int first = one.get(0).compareTo(other.get(0));
    return first != 0 || one.size() == 1 ? first : one.get(1).compareTo(other.get(1));
  }

  private static String table(
      List<String> names,
      Set<BigDecimal> lines,
      Set<BigDecimal> columns,
      Map<List<BigDecimal>, String> words) {
    List<List<String>> cells = new ArrayList<>();
    List<String> heading = new ArrayList<>();
    heading.add(names.size() == 1 ? names.get(0) : names.get(0) + " \\ " + names.get(1));
    columns.forEach(column -> heading.add(column.toPlainString()));
    cells.add(heading);
    for (BigDecimal line : lines) {
      List<String> cell = new ArrayList<>(List.of(line.toPlainString()));
      if (columns.isEmpty()) {
        cell.add(words.get(List.of(line)));
      }
      columns.forEach(column -> cell.add(words.getOrDefault(List.of(line, column), "")));
      cells.add(cell);
    }
    return aligned(cells);
  }

  private static String aligned(List<List<String>> cells) {
    List<Integer> widths = new ArrayList<>(Collections.nCopies(WIDEST + 2, 0));
    for (List<String> line : cells) {
      for (int i = 0; i < line.size(); i++) {
        widths.set(i, Math.max(widths.get(i), line.get(i).length()));
      }
    }
    StringBuilder text = new StringBuilder();
    for (List<String> line : cells) {
      StringBuilder row = new StringBuilder();
      for (int i = 0; i < line.size(); i++) {
        row.append("  ")
            .append(" ".repeat(widths.get(i) - line.get(i).length()))
            .append(line.get(i));
      }
      text.append(row).append('\n');
    }
    return text.toString();
  }
}

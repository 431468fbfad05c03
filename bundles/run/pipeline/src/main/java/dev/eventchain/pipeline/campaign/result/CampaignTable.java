package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.documents.CsvText;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * The cases as a table (RFC 4180, with line feeds): number, further columns, factors, repetition,
 * verdict, impact speed, end, the margin of each criterion with its unit, and the reason.
 */
public final class CampaignTable {

  private final List<String> factors;
  private final List<CampaignRow> rows;

  /** A column: that of a criterion whose margin has a unit. A criterion may have several. */
  private record Column(String criterion, String unit) {}

  private final Set<Column> columns = new LinkedHashSet<>();
  private final Map<String, List<String>> further = new LinkedHashMap<>();

  public CampaignTable(List<String> factors, List<CampaignRow> rows) {
    this.factors = factors;
    this.rows = rows;
    for (CampaignRow row : rows) {
      for (CriterionMargin each : row.result().criteria()) {
        if (each.margin().isPresent()) {
          columns.add(new Column(each.name(), each.unit()));
        }
      }
    }
  }

  /** Adds a column after the first one, with a cell for each case. */
  public CampaignTable with(String name, List<String> cells) {
    further.put(name, cells);
    return this;
  }

  public byte[] csv() {
    List<String> head = new ArrayList<>(List.of("case"));
    head.addAll(further.keySet());
    head.addAll(factors);
    head.addAll(List.of("repetition", "verdict", "impact_speed_mps", "end_s"));
    columns.forEach(it -> head.add("margin of " + it.criterion() + " in " + it.unit()));
    head.add("reason");
    CsvText text = new CsvText("\n");
    text.row(head);
    for (int i = 0; i < rows.size(); i++) {
      text.row(cells(i + 1, rows.get(i)));
    }
    return text.bytes();
  }

  private List<String> cells(int number, CampaignRow row) {
    CaseResult result = row.result();
    List<String> cells = new ArrayList<>(List.of(Integer.toString(number)));
    further.values().forEach(column -> cells.add(column.get(number - 1)));
    row.id().values().stream().map(BigDecimal::toPlainString).forEach(cells::add);
    cells.add(Integer.toString(row.id().repetition()));
    cells.add(row.word());
    cells.add(cell(result.impactSpeed()));
    cells.add(Double.toString(result.end()));
    for (Column column : columns) {
      cells.add(
          result.criteria().stream()
              .filter(each -> column.equals(new Column(each.name(), each.unit())))
              .map(each -> cell(each.margin()))
              .findFirst()
              .orElse(""));
    }
    cells.add(row.reason());
    return cells;
  }

  private static String cell(OptionalDouble number) {
    return number.isPresent() ? Double.toString(number.getAsDouble()) : "";
  }
}

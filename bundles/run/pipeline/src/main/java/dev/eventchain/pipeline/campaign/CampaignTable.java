package dev.eventchain.pipeline.campaign;

import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/**
 * The cases as a table (RFC 4180, with line feeds): number, factors, repetition, verdict, impact
 * speed, end, the margin of each criterion with its unit, and the reason.
 */
final class CampaignTable {

  private final List<String> factors;
  private final List<CampaignRow> rows;

  /** Units of the margins by the names of the criteria, in the order of the scenario. */
  private final Map<String, String> units = new LinkedHashMap<>();

  CampaignTable(List<String> factors, List<CampaignRow> rows) {
    this.factors = factors;
    this.rows = rows;
    for (CampaignRow row : rows) {
      for (CriterionMargin each : row.result().criteria()) {
        units.merge(each.name(), each.unit(), (one, other) -> one.isEmpty() ? other : one);
      }
    }
    units.values().removeIf(String::isEmpty);
  }

  String csv() {
    List<String> head = new ArrayList<>(List.of("case"));
    head.addAll(factors);
    head.addAll(List.of("repetition", "verdict", "impact_speed_mps", "end_s"));
    units.forEach((name, unit) -> head.add("margin of " + name + " in " + unit));
    head.add("reason");
    StringBuilder text = new StringBuilder(line(head));
    for (int i = 0; i < rows.size(); i++) {
      text.append(line(cells(i + 1, rows.get(i))));
    }
    return text.toString();
  }

  private List<String> cells(int number, CampaignRow row) {
    CaseResult result = row.result();
    List<String> cells = new ArrayList<>(List.of(Integer.toString(number)));
    row.id().values().stream().map(BigDecimal::toPlainString).forEach(cells::add);
    cells.add(Integer.toString(row.id().repetition()));
    cells.add(result.label().name().toLowerCase(Locale.ROOT));
    cells.add(cell(result.impactSpeed()));
    cells.add(Double.toString(result.end()));
    for (String name : units.keySet()) {
      cells.add(
          result.criteria().stream()
              .filter(each -> each.name().equals(name))
              .map(each -> cell(each.margin()))
              .findFirst()
              .orElse(""));
    }
    cells.add(result.reason());
    return cells;
  }

  private static String cell(OptionalDouble number) {
    return number.isPresent() ? Double.toString(number.getAsDouble()) : "";
  }

  private static String line(List<String> cells) {
    return cells.stream().map(CampaignTable::quoted).collect(Collectors.joining(",", "", "\n"));
  }

  private static String quoted(String cell) {
    return cell.matches("(?s).*[\",\\r\\n].*") ? '"' + cell.replace("\"", "\"\"") + '"' : cell;
  }
}

package dev.eventchain.mcp.project;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.documents.CsvRow;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * Results as a table.
 *
 * @param rows the values by column: texts, numbers and truth values; an empty cell has none
 */
public record Table(List<String> columns, List<Map<String, Object>> rows) {

  private static final Pattern NUMBER =
      Pattern.compile("-?(?:0|[1-9][0-9]{0,14})(?:\\.[0-9]{1,15})?(?:[eE][+-]?[0-9]{1,2})?");

  /** Reads a table from CSV, whose first row has the names of the columns. */
  static Table ofCsv(String text) {
    List<List<String>> cells = CsvRow.rows(text).stream().map(CsvRow::cells).toList();
    if (cells.isEmpty()) {
      return new Table(List.of(), List.of());
    }
    List<String> columns = cells.get(0);
    List<Map<String, Object>> rows = new ArrayList<>();
    for (List<String> row : cells.subList(1, cells.size())) {
      Map<String, Object> values = new LinkedHashMap<>();
      for (int i = 0; i < Math.min(row.size(), columns.size()); i++) {
        if (!row.get(i).isEmpty()) {
          values.put(columns.get(i), value(row.get(i)));
        }
      }
      rows.add(values);
    }
    return new Table(columns, rows);
  }

  private static Object value(String cell) {
    return switch (cell) {
      case "true" -> true;
      case "false" -> false;
      default -> NUMBER.matcher(cell).matches() ? number(cell) : cell;
    };
  }

  private static Object number(String cell) {
    boolean whole = cell.chars().allMatch(each -> each == '-' || Character.isDigit(each));
    return whole ? (Object) Long.valueOf(cell) : Double.valueOf(cell);
  }

  /**
   * Reads a table from objects; an object in an object gives columns with a dot, and a list of
   * texts one text.
   */
  static Table ofObjects(List<JsonNode> objects) {
    Set<String> columns = new LinkedHashSet<>();
    List<Map<String, Object>> rows = new ArrayList<>();
    for (JsonNode object : objects) {
      Map<String, Object> row = new LinkedHashMap<>();
      flatten("", object, row);
      columns.addAll(row.keySet());
      rows.add(row);
    }
    return new Table(List.copyOf(columns), rows);
  }

  private static void flatten(String prefix, JsonNode object, Map<String, Object> row) {
    object
        .properties()
        .forEach(
            each -> {
              String name = prefix + each.getKey();
              JsonNode value = each.getValue();
              if (value.isObject()) {
                flatten(name + ".", value, row);
              } else if (value.isArray()) {
                row.put(name, listed(value));
              } else if (value.isNumber()) {
                row.put(name, value.numberValue());
              } else if (value.isBoolean()) {
                row.put(name, value.booleanValue());
              } else if (!value.isNull()) {
                row.put(name, value.asText());
              }
            });
  }

  private static String listed(JsonNode values) {
    List<String> texts = new ArrayList<>();
    values.forEach(each -> texts.add(each.isValueNode() ? each.asText() : each.toString()));
    return String.join(", ", texts);
  }
}

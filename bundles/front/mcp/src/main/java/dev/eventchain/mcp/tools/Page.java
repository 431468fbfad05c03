package dev.eventchain.mcp.tools;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Rows that are sent together.
 *
 * @param rows the cells by column
 * @param text the same as lines, with tabs between the cells, after one with the columns
 */
record Page(List<Map<String, Object>> rows, String text) {

  /** Largest number of rows. */
  static final int MOST = 500;

  private static final int LARGEST = 50_000;

  /**
   * Returns the first of some rows, as many as are wanted and not too much for an agent, but one at
   * least.
   */
  static Page of(List<String> columns, List<Map<String, Object>> rows, int wanted) {
    List<Map<String, Object>> sent = new ArrayList<>();
    StringBuilder text = new StringBuilder(String.join("\t", columns)).append('\n');
    for (Map<String, Object> row : rows) {
      if (sent.size() == Math.min(wanted, MOST) || (text.length() > LARGEST && !sent.isEmpty())) {
        break;
      }
      Map<String, Object> cells = new LinkedHashMap<>();
      List<String> line = new ArrayList<>();
      for (String column : columns) {
        Object cell = row.get(column);
        line.add(cell == null ? "" : cell.toString().replaceAll("\\s+", " "));
        if (cell != null) {
          cells.put(column, cell);
        }
      }
      sent.add(cells);
      text.append(String.join("\t", line)).append('\n');
    }
    return new Page(sent, text.toString());
  }
}

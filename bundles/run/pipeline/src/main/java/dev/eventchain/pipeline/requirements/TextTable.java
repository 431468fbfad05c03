package dev.eventchain.pipeline.requirements;

import java.util.List;

/** A table in plain text, whose columns are as wide as their longest cell. */
final class TextTable {

  private TextTable() {}

  /** Returns the lines of a table; all rows have as many cells. */
  static String of(List<List<String>> rows) {
    StringBuilder text = new StringBuilder();
    for (List<String> row : rows) {
      StringBuilder line = new StringBuilder();
      for (int i = 0; i < row.size(); i++) {
        int column = i;
        int width = rows.stream().mapToInt(each -> each.get(column).length()).max().orElse(0);
        line.append(row.get(i)).append(" ".repeat(width - row.get(i).length() + 2));
      }
      text.append(line.toString().stripTrailing()).append('\n');
    }
    return text.toString();
  }
}

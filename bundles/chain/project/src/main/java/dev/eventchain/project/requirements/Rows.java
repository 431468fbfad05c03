package dev.eventchain.project.requirements;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Rows of a table whose columns are places in its lines. */
final class Rows {

  final List<TextBlock.Row> all = new ArrayList<>();
  private final List<int[]> columns;
  private String[] open;
  private int start;

  /**
   * Creates it.
   *
   * @param columns where each begins, and where it ends
   */
  Rows(List<int[]> columns) {
    this.columns = columns;
    this.open = new String[0];
  }

  /** Adds a line to the current row. */
  void add(int number, String line) {
    if (open.length == 0) {
      open = new String[columns.size()];
      Arrays.fill(open, "");
      start = number;
    }
    for (int i = 0; i < open.length; i++) {
      int from = Math.min(columns.get(i)[0], line.length());
      int to = Math.min(columns.get(i)[1], line.length());
      open[i] = (open[i] + " " + line.substring(from, Math.max(from, to)).strip()).strip();
    }
  }

  /** Adds a line, which is a row of its own unless its first cell is empty. */
  void addSimple(int number, String line) {
    int to = Math.min(columns.get(0)[1], line.length());
    if (!line.substring(Math.min(columns.get(0)[0], to), to).isBlank()) {
      end();
    }
    add(number, line);
  }

  /** Ends the current row. */
  void end() {
    if (open.length > 0) {
      all.add(new TextBlock.Row(start, List.of(open)));
    }
    open = new String[0];
  }

  /** Returns the table with the first rows as one header; empty without rows. */
  Optional<TextBlock> table(int number, int head) {
    if (all.size() < head) {
      return Optional.empty();
    }
    String[] header = new String[columns.size()];
    for (int i = 0; i < header.length; i++) {
      StringBuilder text = new StringBuilder();
      for (TextBlock.Row row : all.subList(0, head)) {
        text.append(' ').append(row.cells().get(i));
      }
      header[i] = text.toString().strip();
    }
    return Optional.of(
        new TextBlock.Table(number, List.of(header), List.copyOf(all.subList(head, all.size()))));
  }
}

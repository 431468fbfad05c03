package dev.eventchain.documents;

import java.util.ArrayList;
import java.util.List;

/**
 * A row of a table in CSV.
 *
 * @param line the line of the text at which it begins, from 1
 * @param cells without their quotes
 */
public record CsvRow(int line, List<String> cells) {

  /**
   * Returns the rows of a text, with cells that are quoted as RFC 4180 has it, also over lines.
   * Empty lines are no rows, and a last line needs no end.
   */
  public static List<CsvRow> rows(String text) {
    Reader reader = new Reader(text);
    List<CsvRow> rows = new ArrayList<>();
    while (reader.at < text.length()) {
      CsvRow row = reader.row();
      if (!row.cells().equals(List.of(""))) {
        rows.add(row);
      }
    }
    return rows;
  }

  /** Position in a text. */
  private static final class Reader {

    private final String text;
    private int at;
    private int line = 1;

    Reader(String text) {
      this.text = text;
    }

    CsvRow row() {
      int first = line;
      List<String> cells = new ArrayList<>();
      do {
        cells.add(cell());
      } while (take(','));
      take('\r');
      take('\n');
      return new CsvRow(first, List.copyOf(cells));
    }

    private boolean take(char expected) {
      boolean there = at < text.length() && text.charAt(at) == expected;
      if (there) {
        next();
      }
      return there;
    }

    private char next() {
      char taken = text.charAt(at++);
      line += taken == '\n' ? 1 : 0;
      return taken;
    }

    private String cell() {
      StringBuilder cell = new StringBuilder();
      boolean quoted = take('"');
      while (quoted && at < text.length()) {
        boolean quote = take('"');
        quoted = !quote || take('"');
        if (quoted) {
          cell.append(quote ? '"' : next());
        }
      }
      while (at < text.length() && ",\r\n".indexOf(text.charAt(at)) < 0) {
        cell.append(next());
      }
      return cell.toString();
    }
  }
}

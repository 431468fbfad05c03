package dev.eventchain.mcp.project;

import java.util.ArrayList;
import java.util.List;

/** The cells of a CSV text, as RFC 4180 quotes them. */
final class Csv {

  private final String text;
  private int at;

  private Csv(String text) {
    this.text = text;
  }

  /** Returns the rows, the head first; empty lines are none. */
  static List<List<String>> rows(String text) {
    Csv csv = new Csv(text);
    List<List<String>> rows = new ArrayList<>();
    while (csv.at < text.length()) {
      List<String> row = csv.row();
      if (row.size() > 1 || !row.get(0).isEmpty()) {
        rows.add(row);
      }
    }
    return rows;
  }

  private List<String> row() {
    List<String> cells = new ArrayList<>();
    do {
      cells.add(cell());
    } while (take(','));
    take('\r');
    take('\n');
    return cells;
  }

  private boolean take(char expected) {
    boolean there = at < text.length() && text.charAt(at) == expected;
    at += there ? 1 : 0;
    return there;
  }

  private String cell() {
    StringBuilder cell = new StringBuilder();
    if (take('"')) {
      while (at < text.length()) {
        if (take('"')) {
          if (!take('"')) {
            return cell.toString();
          }
          cell.append('"');
        } else {
          cell.append(text.charAt(at++));
        }
      }
    }
    while (at < text.length() && ",\r\n".indexOf(text.charAt(at)) < 0) {
      cell.append(text.charAt(at++));
    }
    return cell.toString();
  }
}

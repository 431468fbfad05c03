package dev.eventchain.documents;

import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.stream.Collectors;

/** A table as text, with cells that are quoted where RFC 4180 asks for it. */
public final class CsvText {

  private final String lineEnd;
  private final StringBuilder text = new StringBuilder();

  /**
   * Creates an empty table.
   *
   * @param lineEnd what ends a row: CR LF in RFC 4180, LF where people compare versions of a file
   */
  public CsvText(String lineEnd) {
    this.lineEnd = lineEnd;
  }

  /** Adds a row. */
  public void row(Collection<String> cells) {
    text.append(cells.stream().map(CsvText::cell).collect(Collectors.joining(",")));
    text.append(lineEnd);
  }

  private static String cell(String content) {
    boolean plain = content.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? content : '"' + content.replace("\"", "\"\"") + '"';
  }

  /** Returns the table in UTF-8. */
  public byte[] bytes() {
    return text.toString().getBytes(StandardCharsets.UTF_8);
  }
}

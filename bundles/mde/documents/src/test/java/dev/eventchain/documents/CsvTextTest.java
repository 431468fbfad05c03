package dev.eventchain.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests tables in the format of RFC 4180. */
class CsvTextTest {

  @Test
  void cellsAreQuotedOnlyWhereTheyMustBe() {
    CsvText table = new CsvText("\r\n");
    table.row(List.of("plain", "", "a b", "ä"));
    table.row(List.of("one, two", "say \"no\"", "two\nlines", "\r"));
    assertEquals(
        "plain,,a b,ä\r\n\"one, two\",\"say \"\"no\"\"\",\"two\nlines\",\"\r\"\r\n",
        new String(table.bytes(), StandardCharsets.UTF_8));
  }

  @Test
  void whatIsWrittenIsRead() {
    CsvText table = new CsvText("\r\n");
    table.row(List.of("plain", "", "a b", "ä"));
    table.row(List.of("one, two", "say \"no\"", "two\nlines", "\r"));
    table.row(List.of("last"));
    assertEquals(
        List.of(
            new CsvRow(1, List.of("plain", "", "a b", "ä")),
            new CsvRow(2, List.of("one, two", "say \"no\"", "two\nlines", "\r")),
            new CsvRow(4, List.of("last"))),
        CsvRow.rows(new String(table.bytes(), StandardCharsets.UTF_8)));
  }

  @Test
  void emptyLinesAreNoRows() {
    assertEquals(List.of(), CsvRow.rows("\n\r\n"));
    assertEquals(List.of(new CsvRow(2, List.of("a", ""))), CsvRow.rows("\na,\n\n"));
    assertEquals(List.of(new CsvRow(1, List.of("open, "))), CsvRow.rows("\"open, "));
  }
}

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
}

package dev.eventchain.simulation.formula;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests that the rule page, which is shown without the site, has the operators as they are. */
class OperatorTableTest {

  @Test
  void rulePageHasAllOperators() throws IOException {
    Path page = Path.of("rules/scenario.formula.syntax.md");
    List<String> written =
        Files.readAllLines(page).stream().filter(line -> line.startsWith("| `")).toList();
    List<String> known =
        Arrays.stream(Operator.values())
            .map(each -> "| `%s` | %s |".formatted(each.written(), each.meaning()))
            .toList();
    assertEquals(String.join("\n", known), String.join("\n", written), page::toString);
  }
}

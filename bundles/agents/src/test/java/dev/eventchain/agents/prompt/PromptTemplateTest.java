package dev.eventchain.agents.prompt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Prompts as files with placeholders. */
class PromptTemplateTest {
  private static final String PAPER = "%% paper: ";
  private static final PromptTemplate TEMPLATE =
      PromptTemplate.of("test/v1", "%% a remark\nUse {{a}} and {{b c}}.\n");

  @Test
  void placesAreFilledAndRemarksAreNotSent() {
    assertEquals("Use 1 and 2.", TEMPLATE.render(Map.of("a", "1", "b c", "2")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"{{b c}}", "{{other}}", "${x} $1 \\1", "%% kept", "{\"a\": {\"b\": {}}}"})
  void whatAValueHoldsMeansNothing(String value) {
    assertEquals("Use " + value + " and 2.", TEMPLATE.render(Map.of("a", value, "b c", "2")));
  }

  @Test
  void lineEndsOfWindowsAndAtTheEndOfAValueDoNotChangeAPrompt() {
    assertEquals("Use 1\n1 and 2.", TEMPLATE.render(Map.of("a", "1\r\n1\r\n", "b c", "2\n\n")));
  }

  @Test
  void aPlaceWithoutAValueIsAnError() {
    Exception e =
        assertThrows(IllegalArgumentException.class, () -> TEMPLATE.render(Map.of("a", "1")));
    assertEquals("prompt test/v1 has the places [a, b c], but was given [a]", e.getMessage());
  }

  @Test
  void aValueWithoutAPlaceIsAnError() {
    assertThrows(
        IllegalArgumentException.class,
        () -> TEMPLATE.render(Map.of("a", "1", "b c", "2", "d", "3")));
  }

  @ParameterizedTest
  @CsvSource({"design/v1, appendix-a.txt", "implement/v1, appendix-b.txt"})
  void thePapersPromptsStandWordForWordBetweenWhatIsAdded(String prompt, String paper)
      throws IOException {
    StringBuilder base = new StringBuilder();
    boolean added = false;
    for (String line : PromptTemplate.resource(prompt + ".md").lines().toList()) {
      if (line.startsWith(PAPER)) {
        base.append(line.substring(PAPER.length())).append('\n');
      } else if (line.startsWith("%%")) {
        added = line.strip().equals("%% added") || (added && !line.strip().equals("%% end"));
      } else if (!added) {
        base.append(line).append('\n');
      }
    }
    String expected = Files.readString(Path.of("src/test/resources/paper").resolve(paper));
    assertEquals(expected, base.toString().replace("{{system}}", "Autonomous Emergency Braking"));
  }

  @Test
  void everyPromptSaysWhereItComesFrom() {
    for (String prompt : new String[] {"design", "implement", "model", "constrain", "repair"}) {
      String text = PromptTemplate.resource(prompt + "/v1.md");
      assertTrue(text.lines().findFirst().orElse("").endsWith(", version 1."), prompt);
    }
  }
}

package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Designed chains with one fault each, and the findings about them. */
class DesignCheckTest {
  private static final Path RESOURCES = Path.of("src/test/resources");
  private static final Path BASE = Path.of("src/test/resources/design/base");
  private static final SoftwareBase SOFTWARE = SoftwareBase.read(BASE);
  private static final MessageCatalog MESSAGES = MessageCatalog.of(List.of());
  private static final Requirements REQUIREMENTS =
      Requirements.read(SourceText.read(BASE.resolve("requirements.md")));

  @Test
  void theBaseItselfIsFine() {
    assertEquals(List.of(), SOFTWARE.diagnostics());
    assertEquals(List.of(), REQUIREMENTS.diagnostics());
  }

  @ParameterizedTest
  @MethodSource
  void eachFaultIsFoundWhereItIs(Path file) throws IOException {
    List<Diagnostic> found =
        DesignAgent.check(SourceText.read(file), REQUIREMENTS, SOFTWARE, MESSAGES).stream()
            .sorted()
            .toList();
    FindingLines.check(file, found);
  }

  /** Processors are stated by hand: an answer that is asked for none is not refused for them. */
  @Test
  void noDesignIsRefusedForAProcessor() {
    String component =
        "{\"name\": \"%s\", \"frequency\": 20, \"worst_case_execution_time\": 40, \"processor\": \"ecu\"}";
    SourceText chain =
        SourceText.of(
            "chain.json", "[" + component.formatted("A") + "," + component.formatted("B") + "]");
    List<Diagnostic> found = DesignAgent.check(chain, REQUIREMENTS, SOFTWARE, MESSAGES);
    assertEquals(
        List.of(), found.stream().filter(it -> it.id().startsWith("chain.processor")).toList());
  }

  static List<Path> eachFaultIsFoundWhereItIs() throws IOException {
    return ExpectedFile.inputs(RESOURCES.resolve("design"), ".json");
  }

  @Test
  void anAnswerThatFailsItsCheckIsRepaired() {
    Path folder = Path.of("src/test/resources/design");
    String wrong = SourceText.read(folder.resolve("invented-topic.json")).text();
    String right = SourceText.read(folder.resolve("valid.json")).text();
    ScriptedModel model = new ScriptedModel().answer(wrong).answer("```json\n" + right + "```");
    AgentResult result =
        new DesignAgent(AgentContext.of(model))
            .design(
                new DesignAgent.Asked(
                    "Test", 20.0, REQUIREMENTS, Optional.empty(), SOFTWARE, MESSAGES));
    assertEquals("design/v1", result.prompt());
    assertEquals(2, result.attempts().size());
    String prompt = model.requests.get(0).messages().get(0).content();
    assertEquals(1, prompt.split("R-2: The system shall brake", -1).length - 1);
    assertEquals(1, prompt.split("new one with 20 Hz", -1).length - 1);
    String repair = model.requests.get(1).messages().get(2).content();
    assertEquals(1, repair.split("reads /sensor/distance", -1).length - 1);
  }

  /** Strict modes give an object around the array, and null for empty properties. */
  @Test
  void anAnswerInTheShapeOfTheSchemaBecomesTheArray() {
    String array = SourceText.read(RESOURCES.resolve("design/valid.json")).text();
    String value = "\"field\":";
    assertTrue(array.contains(value));
    String withNulls = array.replace(value, "\"safe_value\": null, " + value);
    AgentResult asArray = design(array);
    assertTrue(asArray.text().startsWith("["));
    assertEquals(asArray.text(), design("{\"components\": " + array + "}").text());
    AgentResult result = design("```json\n{\"components\": " + withNulls + "}\n```");
    assertEquals(1, result.attempts().size());
    assertEquals(asArray.text(), result.text());
  }

  private static AgentResult design(String answer) {
    return new DesignAgent(AgentContext.of(new ScriptedModel().answer(answer)))
        .design(
            new DesignAgent.Asked(
                "Test", 20.0, REQUIREMENTS, Optional.empty(), SOFTWARE, MESSAGES));
  }
}

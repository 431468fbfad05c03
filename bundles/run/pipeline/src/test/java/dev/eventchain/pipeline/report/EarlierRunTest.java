package dev.eventchain.pipeline.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the report's comparison with another run. */
class EarlierRunTest {

  private static final String MEASURED =
      """
      {"scenarios": [
        {"name": "a", "passed": false, "criteria": [{"text": "no impact"}], "series": {"time": [0]}},
        {"name": "gone", "passed": true}
      ]}
      """;

  @TempDir private Path folder;

  private static JsonNode json(String text) throws IOException {
    return new JsonMapper().readTree(text);
  }

  private EarlierRun read(String text) throws IOException {
    Files.writeString(folder.resolve("measurements.json"), text);
    return EarlierRun.read(Optional.of(folder));
  }

  @Test
  void scenarioStandsBesideTheOneOfItsName() throws IOException {
    JsonNode now = json("[{\"name\": \"a\", \"passed\": true}, {\"name\": \"new\"}]");
    JsonNode both = read(MEASURED).beside(now);
    assertEquals(2, both.size());
    assertTrue(both.at("/0/passed").booleanValue());
    assertEquals("no impact", both.at("/0/before/criteria/0/text").asText());
    assertTrue(both.at("/1/before").isMissingNode());
    assertTrue(now.at("/0/before").isMissingNode(), "what this run made stays as it is");
  }

  @Test
  void withoutAnotherRunNothingIsAdded() throws IOException {
    JsonNode now = json("[{\"name\": \"a\"}]");
    assertEquals(now, EarlierRun.read(Optional.empty()).beside(now));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "{", "[]", "{\"scenarios\": []}", "{\"passed\": true}"})
  void whatIsNoRunIsRefused(String text) {
    DiagnosticException refused = assertThrows(DiagnosticException.class, () -> read(text));
    assertEquals("project.comparison.unreadable", refused.diagnostics().get(0).id());
  }

  @Test
  void whatIsNotThereIsRefused() {
    Path missing = folder.resolve("nowhere");
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> EarlierRun.read(Optional.of(missing)));
    assertEquals("project.comparison.unreadable", refused.diagnostics().get(0).id());
    assertEquals("There is no such file.", refused.diagnostics().get(0).message());
  }
}

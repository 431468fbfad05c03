package dev.eventchain.pipeline.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.pipeline.results.Criterion;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.results.SimulatedScenario;
import dev.eventchain.pipeline.results.SimulatedScenario.Mover;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the report's comparison with another run. */
class EarlierRunTest {

  private static final String MEASURED =
      """
      {"runId": "1", "scenarios": [
        {"name": "a", "title": "A", "tested": true, "passed": false,
         "criteria": [{"text": "no impact"}], "series": {"time": [0]}},
        {"name": "gone", "title": "B", "tested": true, "passed": true, "criteria": [], "series": {}}
      ]}
      """;

  @TempDir private Path folder;

  private static SimulatedScenario scenario(String name, Criterion... criteria) {
    Mover ego = new Mover("ego", 4, 2, List.of(), List.of(), List.of());
    return new SimulatedScenario(
        name,
        name,
        true,
        true,
        "1 criterion holds",
        List.of(),
        List.of(criteria),
        List.of(),
        List.of(),
        Optional.empty(),
        new SimulatedScenario.Series(List.of(), List.of()),
        new SimulatedScenario.Scene(0, 3, 20, List.of(), ego, List.of(), List.of()),
        List.of());
  }

  private EarlierRun read(String text) throws IOException {
    Files.writeString(folder.resolve("measurements.json"), text);
    return EarlierRun.read(Optional.of(folder));
  }

  @Test
  void scenarioStandsBesideTheOneOfItsName() throws IOException {
    JsonNode both = read(MEASURED).beside(List.of(scenario("a"), scenario("new")));
    assertEquals(2, both.size());
    assertTrue(both.at("/0/passed").booleanValue());
    assertFalse(both.at("/0/before/passed").booleanValue());
    assertTrue(both.at("/0/before/tested").booleanValue());
    assertEquals("no impact", both.at("/0/before/criteria/0/text").asText());
    assertTrue(both.at("/1/before").isMissingNode());
  }

  @Test
  void theLineOfAScenarioSaysWhatIsDifferent() throws IOException {
    String measured =
        """
        {"scenarios": [
          {"name": "a", "tested": true, "passed": false, "criteria": [], "series": {}},
          {"name": "b", "tested": true, "passed": true, "series": {}, "criteria": [
            {"text": "gap", "tested": true, "passed": true, "measured": "3 m"},
            {"text": "stops", "tested": true, "passed": true, "measured": "0 km/h"}]}
        ]}
        """;
    EarlierRun before = read(measured);
    assertEquals("; failed before", before.words(scenario("a")));
    assertEquals("; was not there before", before.words(scenario("c")));
    Criterion stops = criterion("stops", "0 km/h");
    assertEquals("; as before", before.words(scenario("b", criterion("gap", "3 m"), stops)));
    assertEquals(
        "; other figures in 1 of 2 criteria",
        before.words(scenario("b", criterion("gap", "2 m"), stops)));
    assertEquals("", EarlierRun.read(Optional.empty()).words(scenario("a")));
  }

  private static Criterion criterion(String text, String measured) {
    return new Criterion(
        text,
        true,
        true,
        measured,
        Optional.empty(),
        List.of(),
        List.of(),
        Optional.empty(),
        Optional.empty());
  }

  @Test
  void withoutAnotherRunNothingIsAdded() {
    List<SimulatedScenario> now = List.of(scenario("a"));
    assertEquals(ResultJson.tree(now), EarlierRun.read(Optional.empty()).beside(now));
  }

  @ParameterizedTest
  @ValueSource(strings = {"name", "tested", "passed", "criteria", "series"})
  void scenarioWithoutItsMeasurementsIsRefused(String key) {
    String misspelt = MEASURED.replace("\"" + key + "\"", "\"" + key + "s\"");
    DiagnosticException refused = assertThrows(DiagnosticException.class, () -> read(misspelt));
    assertEquals("project.comparison.unreadable", refused.diagnostics().get(0).id());
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

package dev.eventchain.simulation.chain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the phases of nodes. */
class NodeConfigurationTest {

  @TempDir Path folder;

  private double phase(long seed, Map<String, Double> set) throws Exception {
    SimulationRequest request =
        new AebProject(folder.resolve("" + seed + set.size()))
            .request(List.of(AebProject.scenario("stopped-vehicle-50")));
    JsonNode json =
        new NodeConfiguration(request.simulatedChain(), request.nodePackage())
            .of(seed, set, List.of(), List.of());
    for (JsonNode node : json.path("nodes")) {
      if (node.path("name").asText().equals("ObjectDetection")) {
        return node.path("phase_ms").asDouble();
      }
    }
    throw new AssertionError(json);
  }

  @Test
  void aPhaseIsThatOfTheScenarioOrOfItsSeed() throws Exception {
    assertNotEquals(phase(1, Map.of()), phase(2, Map.of()));
    assertEquals(12.5, phase(3, Map.of("ObjectDetection", 12.5)));
  }

  @Test
  void aPhaseOfNoNodeIsFound() {
    Scenario scenario =
        Scenario.parse(
            SourceText.of(
                "s.yaml",
                """
                name: phases
                title: Phases
                duration_s: 5
                ego: {speed_kmh: 50}
                phases_ms: {ObjectDetecton: 3, Planner: 0}
                accept: {no_impact: true}
                """),
            Bench.carla());
    assertEquals(Map.of("ObjectDetecton", 3.0, "Planner", 0.0), scenario.phases());
    List<Diagnostic> found = scenario.unknownNodes(List.of("ObjectDetection", "Planner"));
    assertEquals(
        List.of("s.yaml:5:13: The chain has no node 'ObjectDetecton', whose phase is set here."),
        found.stream().map(each -> each.location() + ": " + each.message()).toList());
    assertEquals("scenario.node.unknown", found.get(0).id());
    assertEquals("Did you mean `ObjectDetection`?", found.get(0).hint());
  }
}

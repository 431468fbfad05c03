package dev.eventchain.simulation.node;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.node.NodeManifest.Component;
import dev.eventchain.simulation.node.NodeManifest.Conversions;
import dev.eventchain.simulation.node.NodeManifest.Node;
import dev.eventchain.simulation.node.NodeManifest.Output;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.ValueSource;

class NodeManifestTest {

  private static final Path GOOD = Path.of("src/test/resources/manifest/good.json");

  @TempDir Path folder;

  @Test
  void everythingIsRead() {
    NodeManifest manifest = NodeManifest.read(SourceText.read(GOOD));
    assertEquals("aeb", manifest.packageName());
    List<Output> outputs = List.of(new Output("ttc", "float32"), new Output("raw", ""));
    Component first =
        new Component(
            "aeb.components.First",
            "First",
            "aeb/components/First.py",
            List.of("a", "b"),
            outputs,
            new Conversions(List.of("b"), List.of()));
    String odd = "Größe \"[/file]\\\n";
    assertEquals(
        new Node(odd, "aeb.first_node", "First_node", Optional.of(first), NodeManifest.Launch.NONE),
        manifest.nodes().get(0));
    assertEquals(3, manifest.nodes().size());
    assertEquals(
        new Node(
            "Third",
            "theirs.third",
            "Third",
            Optional.empty(),
            new NodeManifest.Launch(
                "",
                "/front",
                Map.of("in", "/input"),
                Optional.of(JsonNodeFactory.instance.objectNode().put("side", "left")),
                Optional.of(JsonNodeFactory.instance.objectNode().put("gain", "high")))),
        manifest.nodes().get(2));
    assertEquals("aeb.second_node", manifest.find("Second").orElseThrow().module());
    assertTrue(manifest.find("second").isEmpty());
  }

  @ParameterizedTest
  @CsvFileSource(
      resources = "/manifest/mistakes.csv",
      numLinesToSkip = 1,
      delimiter = '|',
      quoteCharacter = '`')
  void mistakeIsFoundWithItsPlace(String right, String wrong, String element, String message)
      throws Exception {
    String text = Files.readString(GOOD);
    assertTrue(text.contains(right), right);
    int place = text.indexOf(right);
    String changed =
        text.substring(0, place)
            + (wrong == null ? "" : wrong)
            + text.substring(place + right.length());
    String expected = element.equals("\"\"") ? "" : element;
    List<Diagnostic> found = problems(changed);
    assertTrue(
        found.stream()
            .anyMatch(
                finding ->
                    finding.id().equals("simulation.manifest")
                        && finding.location().element().equals(expected)
                        && finding.message().contains(message)),
        found::toString);
    assertTrue(found.stream().noneMatch(finding -> finding.hint().isEmpty()));
    assertTrue(found.stream().allMatch(f -> f.location().file().equals("manifest.json")));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", " ", "null", "[]", "1", "{} {}", "{\"format\": 1, \"format\": 1}", "{"})
  void whatIsNoObjectOfJsonIsRefused(String text) {
    assertEquals("simulation.manifest", problems(text).get(0).id());
  }

  private static List<Diagnostic> problems(String text) {
    DiagnosticException failure =
        assertThrows(
            DiagnosticException.class,
            () -> NodeManifest.read(SourceText.of("manifest.json", text)));
    assertEquals(DiagnosticException.Reason.INPUT, failure.reason());
    return failure.diagnostics();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "aeb/components/TTC_Calculation.py",
        "aeb/ttc_calculation_node.py",
        "aeb/components/Carla_Vehicle_Control.py"
      })
  void fileThatIsNotThereIsNamed(String file) throws Exception {
    AebProject project = new AebProject(folder);
    Files.delete(folder.resolve("aeb").resolve(file));
    DiagnosticException failure = refused(project, project.manifest());
    assertEquals(1, failure.diagnostics().size());
    assertTrue(failure.getMessage().contains(file), failure.getMessage());
  }

  @Test
  void manifestOfAnotherModelIsRefused() throws Exception {
    AebProject project = new AebProject(folder);
    project.chain().getSoftware().get(1).setName("Renamed");
    List<Diagnostic> found = refused(project, project.manifest()).diagnostics();
    assertEquals(2, found.size());
    assertTrue(found.get(0).message().contains("'Renamed'"), found::toString);
    assertEquals("/nodes/1", found.get(1).location().element());
  }

  @Test
  void manifestWithoutNodesSimulatesNothing() throws Exception {
    AebProject project = new AebProject(folder);
    NodeManifest full = project.manifest();
    project.chain().getSoftware().clear();
    NodeManifest empty = new NodeManifest(full.location(), full.packageName(), List.of());
    assertTrue(refused(project, empty).getMessage().contains("nothing to simulate"));
  }

  private static DiagnosticException refused(AebProject project, NodeManifest manifest) {
    SimulationRequest request = project.request(List.of(AebProject.scenario("empty-road")));
    SimulationRequest changed =
        SimulationRequest.of(
            request.chain(),
            request.packageFolder(),
            manifest,
            request.messages(),
            request.bench(),
            request.scenarios());
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> AebProject.simulate(changed));
    assertEquals(DiagnosticException.Reason.INPUT, failure.reason());
    assertEquals("simulation.manifest", failure.diagnostics().get(0).id());
    assertTrue(failure.diagnostics().get(0).location().file().endsWith(NodeManifest.FILE));
    return failure;
  }
}

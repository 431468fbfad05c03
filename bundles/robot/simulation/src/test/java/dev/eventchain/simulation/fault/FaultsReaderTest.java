package dev.eventchain.simulation.fault;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests files with faults, and their schema. */
class FaultsReaderTest {

  private static final Path FILES = Path.of("src/test/resources/faults");
  private static final String EXPECT = "# expect: ";
  private static final JsonSchema SCHEMA =
      JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012).getSchema(FaultPlan.schema());

  /** Findings beyond the schema, which knows no project and no other fault. */
  private static final Set<String> BEYOND_THE_SCHEMA =
      Set.of("fault.unknown", "fault.name.duplicate", "scenario.formula.signal");

  @TempDir static Path folder;

  private static EventChain chain;
  private static List<Scenario> scenarios;

  @BeforeAll
  static void readProject() throws IOException {
    chain = new AebProject(folder).chain();
    scenarios = AebProject.scenarios();
  }

  private static FaultPlan read(Path file) {
    return FaultPlan.read(file, chain, AebProject.BENCH, scenarios);
  }

  private static JsonNode yaml(Path file) {
    DocumentRules ids =
        new DocumentRules(
            Rule.error("a"),
            Rule.error("b"),
            Rule.error("c"),
            Rule.error("d"),
            Rule.error("e"),
            Rule.error("f"));
    return Document.parse(SourceText.read(file), DocumentFormat.YAML, ids, problem -> {}).root();
  }

  @Test
  void whatIsWrittenIsRead() {
    FaultPlan plan = read(FILES.resolve("good.yaml"));
    assertEquals(11, plan.size());
    List<String> words = plan.faults().stream().map(Fault::words).toList();
    assertEquals(
        List.of(
            "kill Braking_Decision from 2 s on",
            "stop TTC_Calculation from 2 s to 2.5 s",
            "stop TTC_Calculation from 2 s to 2.5 s",
            "delay each activation of ObjectDetection by 12.5 ms from 0 s on",
            "flood: ObjectDetection publishes everything 3 times more from 1 s on",
            "drop 50 percent of /scan from 1 s on",
            "drop 100 percent of /carla/ego_vehicle/speedometer from 1 s on",
            "repeat messages on /scan 2 times from 1 s on",
            "corrupt messages on /scan from 1 s on",
            "make the clock jump by -1000 ms from 1 s to 3 s",
            "make the sensor of /carla/ego_vehicle/lidar die from 1 s on"),
        words);
    Fault stopped = plan.faults().get(1);
    assertEquals("stopped-vehicle-50", stopped.scenario().name());
    assertEquals("slow-approach", plan.faults().get(2).scenario().name());
    assertEquals(
        List.of("no impact", "always gap > 0 m"),
        stopped.expected().stream().map(Expectation::text).toList());
    assertEquals(0.4, stopped.detection().orElseThrow().within().orElseThrow());
    assertTrue(plan.faults().get(0).isJudged());
    assertFalse(plan.faults().get(3).isJudged());
  }

  @Test
  void theSchemaTakesWhatIsRead() {
    assertEquals(List.of(), List.copyOf(SCHEMA.validate(yaml(FILES.resolve("good.yaml")))));
  }

  static List<Path> invalid() throws IOException {
    try (Stream<Path> files = Files.list(FILES.resolve("invalid"))) {
      return files.sorted().toList();
    }
  }

  /** The first lines of each file list its findings: id, line, column and pointer. */
  @ParameterizedTest
  @MethodSource("invalid")
  void everyProblemIsFoundAtItsPlace(Path file) throws IOException {
    DiagnosticException refused = assertThrows(DiagnosticException.class, () -> read(file));
    assertEquals(DiagnosticException.Reason.INPUT, refused.reason());
    List<String> expected =
        Files.readAllLines(file).stream()
            .filter(line -> line.startsWith(EXPECT))
            .map(line -> line.substring(EXPECT.length()))
            .toList();
    assertEquals(expected, refused.diagnostics().stream().map(FaultsReaderTest::describe).toList());
  }

  private static String describe(Diagnostic problem) {
    String place = problem.location().line() + ":" + problem.location().column();
    return (problem.id() + " " + place + " " + problem.location().element()).strip();
  }

  static List<Path> invalidButYaml() throws IOException {
    return invalid().stream().filter(file -> !file.endsWith("no-yaml.yaml")).toList();
  }

  /** Excludes findings that depend on the project or on the text. */
  @ParameterizedTest
  @MethodSource("invalidButYaml")
  void theSchemaRefusesTheSame(Path file) throws IOException {
    String first = Files.readAllLines(file).get(0).substring(EXPECT.length()).split(" ", -1)[0];
    String name = file.getFileName().toString();
    boolean beyond =
        BEYOND_THE_SCHEMA.contains(first)
            || Set.of("after-the-end.yaml", "clock-before-the-start.yaml", "key-twice.yaml")
                .contains(name);
    assertEquals(beyond, SCHEMA.validate(yaml(file)).isEmpty(), name);
  }

  @Test
  void faultsOfOtherScenariosAreLeftOutAndThatIsSaid() {
    FaultPlan plan = read(FILES.resolve("good.yaml"));
    assertEquals(1, plan.within(Set.of("slow-approach")).size());
    Diagnostic leftOut = plan.leftOut(Set.of("slow-approach")).orElseThrow();
    assertEquals("simulation.fault.left-out", leftOut.id());
    assertTrue(leftOut.message().startsWith("10 of 11 runs"), leftOut::message);
    assertTrue(plan.leftOut(Set.of("slow-approach", "stopped-vehicle-50")).isEmpty(), "nothing is");
  }
}

package dev.eventchain.simulation.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.Situation;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that the schema of scenarios agrees with the reader. */
class ScenarioSchemaTest {

  private static final Path EXAMPLES = Path.of("../../../examples");
  private static final DocumentRules IDS =
      new DocumentRules(
          Rule.error("a"),
          Rule.error("b"),
          Rule.error("c"),
          Rule.error("d"),
          Rule.error("e"),
          Rule.error("f"));

  private static final JsonSchema SCHEMA =
      JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012).getSchema(Scenario.schema());

  private static JsonNode yaml(SourceText text) {
    return Document.parse(text, DocumentFormat.YAML, IDS, problem -> {}).root();
  }

  static List<Path> everyScenarioOfTheExamplesIsValid() throws IOException {
    try (Stream<Path> files = Files.walk(EXAMPLES)) {
      return files
          .filter(file -> file.getParent().endsWith("scenarios"))
          .filter(file -> file.toString().endsWith(".yaml"))
          .sorted()
          .toList();
    }
  }

  @ParameterizedTest
  @MethodSource
  void everyScenarioOfTheExamplesIsValid(Path file) {
    assertEquals(List.of(), List.copyOf(SCHEMA.validate(yaml(SourceText.read(file)))));
  }

  private static final String SCENARIO =
      """
      name: all
      title: Everything that can stand in a scenario
      duration_s: 20
      road:
        curve_radius_m: -300
        lane_width_m: 3.5
      ego:
        speed_kmh: 50
        lidar_dropout_percent: 2
        lidar_azimuth_step_deg: 1
        speed_step_s: 0.1
        command_timeout_s: 0.5
        maneuvers:
          - at_s: 1
            speed_kmh: 60
            acceleration_mps2: 1
          - at_s: 2
            lateral_offset_m: 0.5
            lateral_speed_mps: 0.3
            shape: linear
            lateral_acceleration_mps2: 0.5
      actors:
        - kind: bicycle
          name: the cyclist
          gap_m: 30
          speed_kmh: 15
          lateral_offset_m: -4
          heading_deg: 90
          length_m: 1.7
          width_m: 0.6
          height_m: 1.7
          bottom_m: 0.1
          maneuvers:
            - at_s: 3
              lateral_offset_m: 1
      furniture:
        - kind: parked_car
          gap_m: 20
          lateral_offset_m: 2.4
          count: 4
          spacing_m: 6
      test_conditions:
        - name: the test speed is kept
          formula: always[0, 3] ego.acceleration >= -1 m/s2
      accept:
        no_impact: true
        settles:
          - {signal: ego.speed, at: 50 km/h, within: 1 km/h, from_s: 3, requirements: [A]}
        requirements:
          no_impact: [B]
      """;

  private static Scenario read(String text) {
    return Scenario.parse(SourceText.of("s.yaml", text), Bench.carla());
  }

  @Test
  void whatIsReadIsValid() {
    assertEquals(List.of(), List.copyOf(SCHEMA.validate(yaml(SourceText.of("s", SCENARIO)))));
    Situation situation = read(SCENARIO).situation();
    assertEquals(5, situation.actors().size());
    assertEquals("the cyclist", situation.actors().get(0).name());
    assertEquals("parked car 4", situation.actors().get(4).name());
    assertEquals(38, situation.actors().get(4).rear(0), 1e-9);
    assertEquals(-1.0 / 300, situation.road().curvature(0));
    assertEquals(0.02, situation.ego().lidar().dropout());
  }

  @ParameterizedTest
  @MethodSource
  void whatIsRefusedIsNotValidEither(List<String> change) {
    String text = SCENARIO.replace(change.get(0), change.get(1));
    assertThrows(DiagnosticException.class, () -> read(text), text);
    assertFalse(SCHEMA.validate(yaml(SourceText.of("s", text))).isEmpty(), text);
  }

  static List<List<String>> whatIsRefusedIsNotValidEither() {
    return List.of(
        List.of("curve_radius_m: -300", "curve_radius_m: 10"),
        List.of("lane_width_m: 3.5", "lane_width: 3.5"),
        List.of("kind: bicycle", "kind: bridge"),
        List.of("kind: bicycle", "kind: tricycle"),
        List.of("kind: parked_car", "kind: lorry"),
        List.of("    count: 4\n", ""),
        List.of("      acceleration_mps2: 1\n", ""),
        List.of("      speed_kmh: 60\n", ""),
        List.of("lateral_speed_mps: 0.3", "lateral_speed_mps: 0"),
        List.of("gap_m: 30", "distance_m: 30"),
        List.of(SCENARIO.substring(SCENARIO.indexOf("  no_impact: true")), "  {}"),
        List.of("requirements: [A]", "requirements: []"),
        List.of("requirements: [A]", "requirements: A"),
        List.of("no_impact: [B]", "no_impct: [B]"),
        List.of("no_impact: [B]", "no_impact: []"),
        List.of("name: the test speed is kept", "title: the test speed is kept"),
        List.of("formula: always[0, 3] ego.acceleration >= -1 m/s2", "judges: {}"),
        List.of("no_impact: true", "no_crash: true"));
  }

  /** Constraints that a schema cannot express. */
  @ParameterizedTest
  @MethodSource
  void refusedByTheReaderOnly(List<String> change) {
    String text = SCENARIO.replace(change.get(0), change.get(1));
    DiagnosticException refused = assertThrows(DiagnosticException.class, () -> read(text), text);
    assertEquals("scenario.value.range", refused.diagnostics().get(0).id());
  }

  static List<List<String>> refusedByTheReaderOnly() {
    return List.of(
        List.of("at_s: 3", "at_s: 30"),
        List.of("bottom_m: 0.1", "bottom_m: 2"),
        List.of("name: the cyclist", "name: ''"),
        List.of("speed_kmh: 15", "speed_kmh: 0"),
        List.of(
            "lateral_offset_m: 1\n",
            "lateral_offset_m: 1\n      - at_s: 3.1\n        lateral_offset_m: 0\n"));
  }

  @Test
  void schemaKnowsAllKindsAndCriteria() throws IOException {
    JsonNode schema = new ObjectMapper().readTree(Scenario.schema());
    ObjectMapper json = new ObjectMapper();
    assertEquals(
        json.valueToTree(ActorKind.ids(true)),
        schema.at("/properties/actors/items/properties/kind/enum"));
    assertEquals(
        json.valueToTree(ActorKind.ids(false)),
        schema.at("/properties/furniture/items/properties/kind/enum"));
    JsonNode accept = schema.at("/properties/accept/properties");
    Arrays.stream(CriterionKind.values())
        .filter(kind -> !kind.always())
        .forEach(kind -> assertFalse(accept.path(kind.key()).isMissingNode(), kind.key()));
    List<String> keyed =
        StreamSupport.stream(schema.at("/$defs/keys/enum").spliterator(), false)
            .map(JsonNode::asText)
            .toList();
    List<String> kinds =
        Stream.concat(
                Arrays.stream(CriterionKind.values())
                    .filter(kind -> !kind.always())
                    .map(CriterionKind::key),
                Stream.of("minimal_time_gap_s", "maximal_lane_offset_m"))
            .toList();
    assertEquals(kinds, keyed);
  }
}

package dev.eventchain.simulation.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.Signal.Direction;
import dev.eventchain.model.Signal.Field;
import dev.eventchain.model.Signal.Values;
import dev.eventchain.simulation.world.Actuator;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that each mistake in {@code bench.yaml} is found at its place, before any simulation. */
class BenchTest {

  private static final Path BENCHES = Path.of("src/test/resources/benches");
  private static final DocumentRules IDS =
      new DocumentRules(
          Rule.error("a"),
          Rule.error("b"),
          Rule.error("c"),
          Rule.error("d"),
          Rule.error("e"),
          Rule.error("f"));

  /** A custom radar and brake, as described in {@code signals.json}. */
  private static final List<dev.eventchain.model.Signal> DECLARED =
      List.of(
          signal(
              "/radar/front",
              "demo_msgs/msg/RadarFront",
              Direction.PROVIDED,
              field("range", "m"),
              field("range_rate", "km/h"),
              field("quality", "")),
          signal("/radar/objects", "demo_msgs/msg/ObjectList", Direction.PROVIDED),
          signal("/camera/left", "std_msgs/msg/Float32", Direction.PROVIDED),
          signal("/radar/roof", "sensor_msgs/msg/PointCloud2", Direction.PROVIDED),
          signal("/radar/rear", "demo_msgs/msg/Detections", Direction.PROVIDED),
          signal("/radar/around", "demo_msgs/msg/Detections", Direction.PROVIDED),
          signal("/scan", "sensor_msgs/msg/LaserScan", Direction.PROVIDED),
          signal("/lamp", "std_msgs/msg/Bool", Direction.CONSUMED),
          signal(
              "/seat",
              "std_msgs/msg/String",
              Direction.PROVIDED,
              limited("string", OptionalDouble.empty(), List.of("EMPTY", "OCCUPIED"))),
          signal(
              "/share",
              "std_msgs/msg/Float32",
              Direction.PROVIDED,
              limited("float32", OptionalDouble.of(100), List.of())),
          signal(
              "/brake/request",
              "demo_msgs/msg/BrakeRequest",
              Direction.CONSUMED,
              field("deceleration", "m/s2"),
              field("pedal", "%"),
              field("force", "furlongs")));

  private static dev.eventchain.model.Signal signal(
      String topic, String type, Direction direction, Field... fields) {
    return new dev.eventchain.model.Signal(
        topic, type, direction, Optional.empty(), List.of(fields), SourceLocation.NONE);
  }

  private static Field field(String path, String unit) {
    return new Field(path, "float32", unit, SourceLocation.NONE);
  }

  private static Field limited(String type, OptionalDouble most, List<String> texts) {
    Values values = new Values(OptionalDouble.empty(), most, texts);
    return new Field("data", type, "", values, SourceLocation.NONE);
  }

  private static Bench read(Path file) {
    MessageCatalog messages = MessageCatalog.of(List.of(BENCHES.resolve("msg")));
    return Bench.read(Optional.of(file), DECLARED, messages);
  }

  private static JsonNode yaml(SourceText text) {
    return Document.parse(text, DocumentFormat.YAML, IDS, problem -> {}).root();
  }

  private static List<Path> files(String folder) throws IOException {
    try (Stream<Path> files = Files.list(BENCHES.resolve(folder))) {
      return files.filter(file -> file.toString().endsWith(".yaml")).sorted().toList();
    }
  }

  static List<Path> invalid() throws IOException {
    return files("invalid");
  }

  @Test
  void proposalKnowsListsOfObjectsByTheNamesOfTheirFields() {
    String proposal =
        Bench.proposal(DECLARED, MessageCatalog.of(List.of(BENCHES.resolve("msg"))), Map.of());
    assertTrue(
        proposal.contains(
            """
              /radar/objects:
                rate_hz: 20
                objects:
                  fields:
                    id: id
                    distance: distance
                    lateral: lateral
                    relative_speed: relative_speed
            #        reserved: ?
            """),
        proposal);
    assertTrue(
        proposal.contains(
            """
                objects:
                  direction_deg: 180
                  count: count
                  fields:
                    detections[].id: id
                    detections[].pose.position.x: x
                    detections[].pose.position.y: y
            """),
        proposal);
    assertTrue(proposal.contains("\n      view_deg: 360\n"), proposal);
    assertTrue(proposal.contains("laser_scan:\n      range_m: 30"), proposal);
    assertTrue(
        proposal.contains("classification: {value: class, classes: {car: 1, pedestrian: 2}}"),
        proposal);
    assertTrue(proposal.contains("label: class\n"), proposal);
  }

  /** A vehicle follows one of two that drive the same, and a commanded speed before pedals. */
  @Test
  void aProposalIsNoConflict() {
    dev.eventchain.model.Signal twist =
        signal(
            "/cmd_vel",
            "geometry_msgs/msg/Twist",
            Direction.CONSUMED,
            field("linear.x", "m/s"),
            field("angular.z", "rad/s"));
    List<dev.eventchain.model.Signal> pedals =
        Stream.of("/front/brake", "/rear/brake", "/steering")
            .map(it -> signal(it, "std_msgs/msg/Float32", Direction.CONSUMED, field("data", "1")))
            .toList();
    MessageCatalog messages = MessageCatalog.of(List.of());
    String proposal = Bench.proposal(pedals, messages, Map.of());
    assertTrue(
        proposal.contains(
            """
              /front/brake:
                fields:
                  data: brake
              /rear/brake:
                observed: true
              /steering:
                fields:
                  data: steering
            """),
        proposal);
    Bench.parse(SourceText.of("bench.yaml", proposal), pedals, messages);
    List<dev.eventchain.model.Signal> all = new ArrayList<>(pedals);
    all.add(twist);
    assertEquals(3, Bench.proposal(all, messages, Map.of()).split("observed: true", -1).length - 1);
  }

  /** {@code findings.txt} lists the findings of each file: id, line, column and text. */
  @Test
  void everyProblemOfAnInvalidBenchIsFoundAtItsPlace() throws IOException {
    StringBuilder found = new StringBuilder();
    for (Path file : invalid()) {
      DiagnosticException failure =
          assertThrows(DiagnosticException.class, () -> read(file), file::toString);
      assertEquals(DiagnosticException.Reason.INPUT, failure.reason());
      for (Diagnostic problem : failure.diagnostics()) {
        SourceLocation place = problem.location();
        found.append(
            String.format(
                Locale.ROOT,
                "%s %s %d:%d %s %s%n",
                file.getFileName(),
                problem.id(),
                place.line(),
                place.column(),
                problem.message(),
                problem.hint()));
      }
    }
    Path expected = BENCHES.resolve("findings.txt");
    if (!Files.exists(expected)) {
      Files.writeString(expected, found);
    }
    assertEquals(Files.readString(expected), found.toString());
  }

  /** An editor with the schema must accept all valid files. */
  @Test
  void schemaAcceptsWhatIsReadAndKnowsAllNames() throws IOException {
    JsonSchema schema =
        JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012).getSchema(Bench.schema());
    for (Path file : files("valid")) {
      read(file);
      assertEquals(List.of(), List.copyOf(schema.validate(yaml(SourceText.read(file)))));
    }
    SourceText carla = SourceText.of("carla.yaml", BenchReader.resource("carla.yaml"));
    assertEquals(List.of(), List.copyOf(schema.validate(yaml(carla))));
    JsonNode drives = new ObjectMapper().readTree(Bench.schema()).at("/$defs/drives/enum");
    List<String> names = Stream.concat(Actuator.ids().stream(), Stream.of("observed")).toList();
    assertEquals(new ObjectMapper().valueToTree(names), drives);
  }

  /** A misspelt field, quantity or unit of the shipped bench would be a finding. */
  @Test
  void carlasBenchFitsTheMessages() {
    Bench bench = Bench.read(Optional.empty(), List.of(), MessageCatalog.of(List.of()));
    assertEquals(
        Set.of("lidar", "vehicle_status", "odometry", "imu", "gnss", "speedometer"),
        bench.provided().keySet().stream()
            .map(topic -> topic.substring("/carla/ego_vehicle/".length()))
            .collect(Collectors.toSet()));
  }

  @ParameterizedTest
  @MethodSource
  void schemaRefuses(String name) throws IOException {
    JsonSchema schema =
        JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012).getSchema(Bench.schema());
    JsonNode bench = yaml(SourceText.read(BENCHES.resolve("invalid/" + name + ".yaml")));
    assertTrue(!schema.validate(bench).isEmpty());
  }

  static List<String> schemaRefuses() {
    return List.of(
        "rate-of-0",
        "rate-of-a-million",
        "no-rate",
        "unknown-key",
        "unknown-base",
        "no-such-sensor",
        "nothing-sent",
        "objects-of-nothing",
        "objects-without-fields",
        "object-property",
        "lost-messages",
        "no-such-actuator",
        "nothing-taken",
        "input-with-both");
  }
}

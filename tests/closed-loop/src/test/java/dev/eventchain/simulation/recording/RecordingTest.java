package dev.eventchain.simulation.recording;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.chain.NodeConfiguration;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.HostProgram;
import dev.eventchain.simulation.host.LockstepProcess;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.run.ScenarioRunner;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests recordings with common MCAP readers. */
class RecordingTest {

  private static final String SCENARIO = "stopped-vehicle-50";
  private static final String READ = "src/test/resources/recordings/read.py";
  private static final Path ENVIRONMENT =
      Repository.ROOT.resolve(
          "bundles/robot/sandbox/src/main/resources/dev/eventchain/sandbox/environment.py");

  @TempDir Path folder;

  private Path recordings;
  private AebProject project;

  @BeforeEach
  void prepare() throws IOException {
    recordings = Files.createDirectory(folder.resolve("recordings"));
    project = new AebProject(Files.createDirectory(folder.resolve("package")));
  }

  private SimulationRequest request() {
    return project
        .request(List.of(AebProject.scenario(SCENARIO)))
        .with(it -> it.withRecordings(recordings));
  }

  /** Reads a recording with rosbags and mcap-ros2-support, which must agree. */
  private JsonNode read(Path file) throws Exception {
    ProcessBuilder builder =
        new ProcessBuilder(
            "python3", ENVIRONMENT.toString(), "--development", "--run", READ, file.toString());
    Process process = builder.redirectErrorStream(true).start();
    String output = new String(process.getInputStream().readAllBytes(), UTF_8);
    assertEquals(0, process.waitFor(), output);
    return new ObjectMapper().readTree(output.strip().lines().reduce((a, b) -> b).orElse(""));
  }

  private Path only() throws IOException {
    try (Stream<Path> files = Files.list(recordings)) {
      List<Path> found = files.toList();
      assertEquals(List.of(recordings.resolve(SCENARIO + ".mcap")), found);
      return found.get(0);
    }
  }

  /** Published messages agree with the nodes' own log; the messages of the world are included. */
  @Test
  void everyMessageIsReadBackAsItWasPublished() throws Exception {
    SimulationRequest request = request();
    SimulatedChain chain = request.simulatedChain();
    PythonEnvironment python = PythonEnvironment.ensure(line -> {});
    ScenarioRun run;
    HostProgram program = new HostProgram(request.nodePackage(), python, Confinement.detect());
    NodeConfiguration nodes = new NodeConfiguration(chain, request.nodePackage());
    try (LockstepProcess process =
        new LockstepProcess(program, request.chain().getSoftware().size(), 0)) {
      run =
          new ScenarioRunner(
                  chain, nodes, request.settings().recordings(), process.session(), Map.of())
              .run(AebProject.scenario(SCENARIO));
    }
    JsonNode read = read(only());
    SortedMap<String, List<Long>> published = new TreeMap<>();
    run.log()
        .publications()
        .forEach((topic, times) -> published.put(topic, sortedBefore(times, end(run))));
    SortedMap<String, List<Long>> recorded = new TreeMap<>();
    read.path("topics")
        .properties()
        .forEach(topic -> recorded.put(topic.getKey(), times(topic.getValue(), end(run))));
    List<Long> scenes = recorded.remove("/tf");
    assertEquals(scenes, recorded.remove("/world/actors"));
    assertTrue(scenes.containsAll(recorded.get("/clock")));
    published.values().removeIf(List::isEmpty);
    assertEquals(published, recorded);
    assertEquals(
        List.of(
            "/carla/ego_vehicle/lidar",
            "/carla/ego_vehicle/vehicle_control_cmd",
            "/carla/ego_vehicle/vehicle_status",
            "/clock"),
        recorded.keySet().stream().filter(t -> t.startsWith("/c")).toList());
    assertTrue(recorded.size() > 6, recorded.keySet().toString());
  }

  private static long end(ScenarioRun run) {
    return run.trace().end().time();
  }

  private static List<Long> sortedBefore(Map<Long, Long> times, long end) {
    return times.values().stream().filter(time -> time < end).sorted().toList();
  }

  private static List<Long> times(JsonNode topic, long end) {
    List<Long> times = new ArrayList<>();
    topic.path("times").forEach(time -> times.add(time.asLong()));
    return times.stream().filter(time -> time < end).sorted().toList();
  }

  @Test
  void theRecordingShowsWhereEverythingIs() throws Exception {
    AebProject.simulate(request());
    JsonNode read = read(only());
    JsonNode transforms = read.path("topics").path("/tf");
    assertEquals(
        "[[\"map\",\"ego_vehicle\"],[\"ego_vehicle\",\"ego_vehicle/lidar\"],[\"map\",\"car_1\"]]",
        transforms.path("frames").toString());
    JsonNode ego = transforms.path("ego");
    assertEquals(0.0, ego.get(0).asDouble());
    assertTrue(ego.get(ego.size() - 1).asDouble() > 10.0, ego.toString());
    assertEquals("at its end", read.path("about").path("ended").asText());
    assertEquals(SCENARIO, read.path("about").path("scenario").asText());
  }

  @InTurn
  @Test
  void theSameRunHasTheSameBytesAndRecordingChangesNothing() throws Exception {
    ObjectNode recorded = json(AebProject.simulate(request()));
    Path kept = Files.move(only(), folder.resolve("first.mcap"));
    AebProject.simulate(request());
    assertArrayEquals(Files.readAllBytes(kept), Files.readAllBytes(only()));
    ObjectNode without = json(project.simulate(List.of(AebProject.scenario(SCENARIO))));
    assertEquals(without, recorded);
  }

  private static ObjectNode json(SimulationResult result) throws IOException {
    ObjectNode json = (ObjectNode) new ObjectMapper().readTree(result.toJson());
    json.remove("host");
    return json;
  }

  @Test
  void whatLedToAFailureIsRecorded() throws Exception {
    Path component = project.component("Braking_Decision");
    Files.writeString(
        component,
        Files.readString(component)
            .replace(
                "        if time_to_collision < PARTIAL",
                "        if time_to_collision < 1.5:\n            raise ValueError\n"
                    + "        if time_to_collision < PARTIAL"));
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> AebProject.simulate(request()));
    JsonNode read = read(only());
    assertEquals(failure.diagnostics().get(0).id(), read.path("about").path("ended").asText());
    assertTrue(read.path("topics").path("/clock").path("times").size() > 20, read.toString());
  }

  @Test
  void aRecordingThatCannotBeWrittenIsAFindingAndNoHalfFile() throws Exception {
    Files.delete(recordings);
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> AebProject.simulate(request()));
    Diagnostic finding = failure.diagnostics().get(0);
    assertEquals("simulation.recording.unwritable", finding.id());
    assertTrue(Files.notExists(recordings));
  }

  /**
   * Covers chunks of a megabyte, a schema for two topics, a topic without messages, and no message.
   */
  @Test
  void manyChunksAndNoneAreReadBack() throws Exception {
    MessageCatalog catalog = MessageCatalog.of(List.of());
    String definition = catalog.text(catalog.find("std_msgs/msg/UInt8MultiArray").orElseThrow());
    for (int count : new int[] {0, 1, 9}) {
      Path file = recordings.resolve(count + ".mcap");
      try (var output = Files.newOutputStream(file)) {
        McapWriter writer = new McapWriter(output);
        for (String topic : List.of("/a", "/b", "/c")) {
          writer.channel(topic, "std_msgs/msg/UInt8MultiArray", definition);
        }
        for (int i = 0; i < count; i++) {
          writer.message(i % 2, i * 1_000L, array(500_000));
        }
        writer.metadata("eventchain", new TreeMap<>(Map.of("ended", "at its end")));
        writer.finish();
      }
      JsonNode topics = read(file).path("topics");
      assertEquals(
          count, topics.path("/a").path("times").size() + topics.path("/b").path("times").size());
      assertTrue(topics.path("/c").isMissingNode());
    }
  }

  /** Returns an array message: an empty layout, and bytes. */
  private static ByteBuffer array(int length) {
    ByteBuffer message = ByteBuffer.allocate(16 + length).order(java.nio.ByteOrder.LITTLE_ENDIAN);
    return message.put(new byte[] {0, 1, 0, 0}).putInt(0).putInt(0).putInt(length).rewind();
  }
}

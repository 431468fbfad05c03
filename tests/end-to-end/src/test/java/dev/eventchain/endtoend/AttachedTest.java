package dev.eventchain.endtoend;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that the world drives nodes that it did not start: here the generated ones, run one by one.
 */
class AttachedTest {

  private static final Path BUNDLES = Program.ROOT.resolve("bundles");
  private static final String SCENARIO =
      """
      name: leaves
      title: The vehicle leaves its lane to the left
      requirements: [LDW-2]
      seed: 1
      duration_s: 4
      road: {lane_width_m: 3.5}
      ego:
        speed_kmh: 80
        maneuvers: [{at_s: 0.2, lateral_offset_m: 1.6, lateral_speed_mps: 0.8}]
      accept:
        formulas:
          - {name: warned, formula: "eventually[0, 4] /cluster/lane_departure.left"}
      """;

  /**
   * Configuration of loopback, which often has no multicast; the tag excludes other users of the
   * domain.
   */
  private static final String LOOPBACK =
      """
      <CycloneDDS><Domain id="any"><General><Interfaces>
      <NetworkInterface address="127.0.0.1" multicast="false"/></Interfaces>
      <AllowMulticast>false</AllowMulticast></General><Discovery>
      <ParticipantIndex>auto</ParticipantIndex>
      <MaxAutoParticipantIndex>99</MaxAutoParticipantIndex>
      <Peers><Peer address="127.0.0.1"/></Peers><Tag>attached-%d</Tag>
      </Discovery></Domain></CycloneDDS>
      """
          .replace("\n", "")
          .formatted(ProcessHandle.current().pid());

  private static final String DOMAIN = Long.toString(1 + ProcessHandle.current().pid() % 100);

  @TempDir private Path folder;

  private static Program attaching() {
    return new Program().with("ROS_DOMAIN_ID", DOMAIN).with("CYCLONEDDS_URI", LOOPBACK);
  }

  @InTurn
  @Test
  void nodesThatOthersStartedAreJudgedByWhatTheVehicleDid() throws Exception {
    ProjectCopy copy = ProjectCopy.of("lane-departure", folder);
    copy.onlyScenario("scenarios/drift-left.yaml");
    copy.write("scenarios/drift-left.yaml", SCENARIO);
    new Program().run("run", copy.path(), "--to", "generate").expect(0);
    Path python = python();
    List<Process> nodes = new ArrayList<>();
    try {
      for (Path file : nodeFiles(copy.path())) {
        nodes.add(start(python, copy.path(), file));
      }
      Program.Ended ended =
          attaching().run("simulate", copy.path(), "--driver", "dds", "--attach").expect(1);
      nodes.forEach(node -> assertTrue(node.isAlive(), this::log));
      String out = ended.out() + ended.err();
      assertTrue(
          out.contains("passed  leaves") || out.contains("ms behind the clock"), out + log());
      ended.says("INCOMPLETE: ").says("(Cyclone DDS, attached to domain " + DOMAIN + ")");
      ended.says("simulation.attached.unseen");
      ended.says("simulation.rule.untested EventChain::WarningWithin200Milliseconds");
      assertFalse(out.contains("simulation.attached.state"), out);
      ObjectMapper json = new ObjectMapper();
      JsonNode measured = json.readTree(copy.path().resolve("out/measurements.json").toFile());
      assertEquals(0, measured.path("nodes").size());
      assertFalse(
          Files.readString(copy.path().resolve("out/chain.measured.xmi")).contains("activations"));
    } finally {
      nodes.forEach(Process::destroyForcibly);
    }
  }

  private String log() {
    try {
      return Files.readString(folder.resolve("nodes.log"));
    } catch (IOException e) {
      return e.toString();
    }
  }

  private static Path python() throws Exception {
    Path environment =
        BUNDLES.resolve("robot/sandbox/src/main/resources/dev/eventchain/sandbox/environment.py");
    Process found =
        new ProcessBuilder("python3", environment.toString(), "--cyclonedds", "--print-executable")
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    String executable = new String(found.getInputStream().readAllBytes(), UTF_8).strip();
    assertEquals(0, found.waitFor());
    return Path.of(executable);
  }

  /** Returns the files of the nodes, according to the manifest. */
  private static List<Path> nodeFiles(Path project) throws IOException {
    Path package_ = generated(project);
    JsonNode manifest =
        new ObjectMapper().readTree(package_.resolve("eventchain-manifest.json").toFile());
    List<Path> files = new ArrayList<>();
    for (JsonNode node : manifest.path("nodes")) {
      files.add(package_.resolve(node.path("module").asText().replace('.', '/') + ".py"));
    }
    return files;
  }

  private static Path generated(Path project) throws IOException {
    try (var files = Files.walk(project.resolve("out"))) {
      return files
          .filter(file -> file.endsWith("eventchain-manifest.json"))
          .findFirst()
          .orElseThrow()
          .getParent();
    }
  }

  private Process start(Path python, Path project, Path file) throws IOException {
    String definitions =
        new Program().run("messages", project.resolve("software-base/msg")).expect(0).out();
    Path messages = Files.writeString(project.resolve("out/messages.json"), definitions);
    ProcessBuilder builder =
        new ProcessBuilder(
            python.toString(),
            "-m",
            "eventchain_ros2",
            "--messages",
            messages.toString(),
            file.toString(),
            "--ros-args",
            "-p",
            "use_sim_time:=true");
    String path =
        String.join(
            File.pathSeparator,
            BUNDLES.resolve("robot/runtime/python").toString(),
            BUNDLES.resolve("robot/sandbox/src/main/resources/dev/eventchain/sandbox").toString(),
            generated(project).toString());
    builder
        .environment()
        .putAll(
            Map.of(
                "PYTHONPATH", path,
                "PYTHONDONTWRITEBYTECODE", "1",
                "ROS_DOMAIN_ID", DOMAIN,
                "CYCLONEDDS_URI", LOOPBACK));
    File log = folder.resolve("nodes.log").toFile();
    return builder
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.appendTo(log))
        .start();
  }

  @Test
  void withoutDdsOrWithoutSimulationItIsWrongUsage() throws IOException {
    Path project = ProjectCopy.of("lane-departure", folder).path();
    new Program()
        .run("simulate", project, "--attach")
        .expect(2)
        .says("--attach needs --driver dds");
    new Program()
        .run("run", project, "--driver", "dds", "--attach", "--to", "generate")
        .expect(2)
        .says("--attach applies to a simulation");
  }
}

package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that {@code init} creates a project that runs, or one around existing software in a folder.
 */
class InitTest {

  @TempDir private Path folder;

  private static List<String> files(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(Files::isRegularFile)
          .map(file -> folder.relativize(file).toString())
          .filter(file -> !file.startsWith("out"))
          .sorted()
          .toList();
    }
  }

  @Test
  void newProjectRunsAsItIsAndIsTheExample() throws IOException {
    Path project = folder.resolve("my project");
    new Program().run("init", project).expect(0).says("bench.yaml").says("Next: eventchain bench");
    assertEquals(files(Program.ROOT.resolve("examples/radar-aeb")), files(project));
    Projects.withoutStrength(project);
    new Program().run("run", project).expect(0).says("PASSED: 2 of 2 scenarios passed");
    new Program().run("init", project).expect(2).says("[project.exists]");
  }

  @Test
  void benchIsFilledInFromTheSignalsAndNothingIsReplaced() throws IOException {
    Path project = folder.resolve("radar");
    Projects.copy(
        Program.ROOT.resolve("examples/radar-aeb/software-base"), project.resolve("software-base"));
    Files.writeString(project.resolve("requirements.md"), "- OWN-1: The system shall brake.\n");
    new Program().run("init", project).expect(0);
    assertEquals(
        "- OWN-1: The system shall brake.\n", Files.readString(project.resolve("requirements.md")));
    assertEquals(
        """
        # How the simulated road and this project are connected; `eventchain bench DIR` lists
        # what there is. What is commented out could not be guessed.
        provides:
          /radar/target:
            rate_hz: 20
            fields:
              valid: lead.present
              range: min(gap, 200 m)
              range_rate: lead.speed - ego.speed
        consumes:
          /brake/request:
            fields:
              active: observed
              acceleration: acceleration
          /cluster/collision_warning:
            observed: true
        """,
        Files.readString(project.resolve("bench.yaml")));
    new Program().run("bench", project).expect(0).says("consumes /brake/request");
  }

  /** A component that reads messages in a list, and laser scans, runs with the bench of init. */
  @Test
  void listsOfObjectsAndLaserScansAreFilledInAndRun() throws IOException {
    Path example = Program.ROOT.resolve("tests/end-to-end/src/test/resources/blind-spot");
    Path project = folder.resolve("blind-spot");
    Projects.copy(example, project);
    Files.delete(project.resolve("scenarios/overtaken.yaml"));
    new Program().run("init", project).expect(0);
    assertEquals(
        """
        provides:
          /radar/rear:
            rate_hz: 20
            objects:
              direction_deg: 180
              fields:
                objects[].id: id
                objects[].position.x: x
                objects[].position.y: y
        #        objects[].position.z: ?
                objects[].range_rate: range_rate
                objects[].classification: {value: class, classes: {car: 1, pedestrian: 2}}
          /scan/left:
            rate_hz: 20
            laser_scan:
              direction_deg: 90
              range_m: 30
        consumes:
          /mirror/left_lamp:
            observed: true
        """,
        Files.readString(project.resolve("bench.yaml")).replaceFirst("(?s)^.*?(?=provides:)", ""));
    Path bench = project.resolve("bench.yaml");
    String wide = "direction_deg: 180\n      view_deg: 150\n";
    Files.writeString(bench, Files.readString(bench).replace("direction_deg: 180\n", wide));
    try (Stream<Path> scenarios = Files.list(project.resolve("scenarios"))) {
      for (Path each : scenarios.toList()) {
        Files.delete(each);
      }
    }
    Files.copy(
        example.resolve("scenarios/overtaken.yaml"), project.resolve("scenarios/overtaken.yaml"));
    Projects.withoutStrength(project);
    new Program().run("run", project).expect(0).says("PASSED: 1 of 1 scenarios passed");
    Path component = project.resolve("software-base/components/Blind_Spot_Monitor.py");
    Files.writeString(component, Files.readString(component).replace("(-5.6, -1.9)", "(1.9, 5.6)"));
    Files.writeString(
        component, Files.readString(component).replace("BESIDE = 4.5", "BESIDE = 0.5"));
    new Program()
        .run("run", project)
        .expect(1)
        .says("not met: the lamp is lit while the car is beside");
  }

  @InTurn
  @Test
  void chainOfTheComponentsIsDrawnFromTheirDescriptions() throws IOException {
    Path project = folder.resolve("My Radar-2");
    Path example = Program.ROOT.resolve("examples/radar-aeb");
    Projects.copy(example.resolve("software-base"), project.resolve("software-base"));
    Path components = project.resolve("software-base/components.json");
    String described = Files.readString(components);
    Files.writeString(
        components,
        described.replaceFirst("\"requirements\": \\[\\]", "\"requirements\": [\"OWN-1\"]"));
    Files.writeString(
        project.resolve("requirements.md"), "- OWN-1: The \"system\" shall:\n  brake.\n");
    new Program().run("init", project).expect(0).says("model/chain.xmi");
    String chain = Files.readString(project.resolve("model/chain.xmi"));
    assertTrue(chain.contains("name=\"my_radar_2\""), chain);
    assertTrue(chain.contains("name=\"Radar_Tracking\""), chain);
    assertTrue(chain.contains("satisfies=\"//@requirements.0\""), chain);
    String scenario = Files.readString(project.resolve("scenarios/stopped-vehicle.yaml"));
    assertTrue(scenario.contains("requirements: [OWN-1]"), scenario);
    assertTrue(scenario.contains("OWN-1: \"The \\\"system\\\" shall: brake.\""), scenario);
    new Program().run("validate", project).expect(0).says("0 errors, 0 warnings");
    new Program().run("run", project).expect(0).says("1 requirement proved");
  }

  /** There is nothing to hit for what drives nothing. */
  @Test
  void theFirstScenarioOfALampIsNoApproach() throws IOException {
    Path project = folder.resolve("lamp");
    Path base = Files.createDirectories(project.resolve("software-base"));
    Files.writeString(
        base.resolve("signals.json"),
        """
        [
          {"Topic Name": "/tank/level", "Message Type": "std_msgs/msg/Float32", "direction": "provided",
           "Message Definition": [{"Field": "data", "Type": "float32", "Unit": "%"}]},
          {"Topic Name": "/cluster/lamp", "Message Type": "std_msgs/msg/Bool", "direction": "consumed",
           "Message Definition": [{"Field": "data", "Type": "bool"}]}
        ]
        """);
    Files.writeString(
        project.resolve("requirements.md"), "- T-1: A lamp shall be lit below 5 %.\n");
    new Program().run("init", project).expect(0).says("scenarios/standing.yaml");
    assertEquals(
        """
        accept:
          formulas:
            # Say what has to hold when it happens, and of each requirement quote the words that this judges.
            - name: nothing is switched on
              judges:
                T-1: "A lamp shall be lit below 5 %."
              formula: always[0.5, 12] not /cluster/lamp.data
        """,
        Files.readString(project.resolve("scenarios/standing.yaml"))
            .replaceFirst("(?s).*(?=accept:)", ""));
  }

  /**
   * Without a command it would run into what stands there, so that standing still proves nothing.
   */
  @Test
  void theFirstScenarioOfARobotIsOneThatItCanDrive() throws IOException {
    Path project = folder.resolve("robot");
    Path base = Files.createDirectories(project.resolve("software-base"));
    Files.writeString(
        base.resolve("signals.json"),
        """
        [
          {"Topic Name": "/odom", "Message Type": "nav_msgs/msg/Odometry", "direction": "provided",
           "Message Definition": [{"Field": "twist.twist.linear.x", "Type": "float64"}]},
          {"Topic Name": "/cmd_vel", "Message Type": "geometry_msgs/msg/Twist", "direction": "consumed",
           "Message Definition": [{"Field": "linear.x", "Type": "float64"}]}
        ]
        """);
    new Program().run("init", project).expect(0).says("scenarios/obstacle-ahead.yaml");
    String scenario = Files.readString(project.resolve("scenarios/obstacle-ahead.yaml"));
    assertTrue(scenario.contains("  speed_kmh: 2\nactors:\n  - gap_m: 8\n"), scenario);
    String bench = Files.readString(project.resolve("bench.yaml"));
    assertTrue(bench.contains("twist.twist.linear.x: {value: ego.speed, unit: m/s}"), bench);
    assertTrue(bench.contains("linear.x: {drives: speed, unit: m/s}"), bench);
  }

  @Test
  void componentsThatNameOtherRequirementsAreRefusedBeforeAnythingIsWritten() throws IOException {
    Path project = folder.resolve("other");
    Path example = Program.ROOT.resolve("examples/radar-aeb");
    Projects.copy(example.resolve("software-base"), project.resolve("software-base"));
    Path components = project.resolve("software-base/components.json");
    String described = Files.readString(components);
    Files.writeString(
        components,
        described.replaceFirst("\"requirements\": \\[\\]", "\"requirements\": [\"OWN-1\"]"));
    new Program()
        .run("init", project)
        .expect(2)
        .says("[modeler.reference.unresolved]")
        .says("components.json:7:");
    assertFalse(Files.exists(project.resolve("eventchain.yaml")));
  }

  @Test
  void signalsWithoutDirectionLeaveABenchThatSaysWhatIsMissing() throws IOException {
    Path project = folder.resolve("undirected");
    Files.createDirectories(project.resolve("software-base"));
    Files.writeString(project.resolve("software-base/signals.json"), "[]\n");
    new Program().run("init", project).expect(0);
    String bench = Files.readString(project.resolve("bench.yaml"));
    assertTrue(bench.contains("has \"direction\": \"provided\".\nprovides: {}\n"), bench);
    assertTrue(bench.contains("has \"direction\": \"consumed\".\nconsumes: {}\n"), bench);
    new Program().run("bench", project).expect(0);
  }

  @Test
  void signalsAreEnoughToBeginWith() throws IOException {
    Path project = folder.resolve("only signals");
    Path base = Program.ROOT.resolve("examples/radar-aeb/software-base");
    Projects.copy(base.resolve("msg"), project.resolve("software-base/msg"));
    Files.copy(base.resolve("signals.json"), project.resolve("software-base/signals.json"));
    new Program().run("init", project).expect(0).says("eventchain run '" + project + "'");
    assertEquals("[]\n", Files.readString(project.resolve("software-base/components.json")));
    new Program().run("bench", project).expect(0).says("provides /radar/target");
  }

  @Test
  void exampleOfCarlaIsConnectedAsCarlaIs() throws IOException {
    Path project = folder.resolve("carla");
    Projects.copy(
        Program.ROOT.resolve("examples/aeb/software-base"), project.resolve("software-base"));
    new Program()
        .run("init", project)
        .expect(0)
        .says("Carla_Vehicle_Control reads /vehicle/brake_force, which no component");
    assertFalse(Files.exists(project.resolve("model")), "a chain that is still to be designed");
    String bench = Files.readString(project.resolve("bench.yaml"));
    assertTrue(bench.contains("    sensor: lidar\n"), bench);
    assertTrue(bench.contains("      velocity: ego.speed\n"), bench);
    assertTrue(bench.contains("      pose.pose.orientation.z: ego.orientation.z\n"), bench);
    assertTrue(bench.contains("#      control.brake: ? # 1\n"), bench);
    assertTrue(bench.contains("#   inputs:\n#     my.control_brake: {value: 0}\n"), bench);
    assertTrue(bench.contains("      brake: brake\n"), bench);
    assertTrue(bench.contains("      hand_brake: hand_brake\n"), bench);
    new Program().run("bench", project).expect(0);
  }

  @Test
  void foreignFolderIsLeftAlone() throws IOException {
    Files.writeString(folder.resolve("thesis.txt"), "mine");
    new Program().run("init", folder).expect(2).says("[project.foreign]");
    assertEquals(List.of("thesis.txt"), files(folder));
  }
}

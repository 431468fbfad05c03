package dev.eventchain.endtoend;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the example on plain Cyclone DDS: the same verdict in simulated time, and values that cross
 * the middleware between processes.
 */
class CycloneDdsTest {

  private static final Path RESOURCES =
      Program.ROOT.resolve("tests/end-to-end/src/test/resources/cyclonedds");
  private static final Path ENVIRONMENT =
      Program.ROOT.resolve(
          "bundles/robot/sandbox/src/main/resources/dev/eventchain/sandbox/environment.py");
  private static final Path CASES =
      Program.ROOT.resolve("bundles/mde/m2t/src/test/resources/cases/cyclonedds-python");

  /**
   * Configuration of loopback, which often has no multicast: all participants are on this machine
   * and found by unicast.
   */
  private static final String LOOPBACK =
      "<CycloneDDS><Domain><General><Interfaces><NetworkInterface address=\"127.0.0.1\"/>"
          + "</Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery><Peers><Peer"
          + " address=\"127.0.0.1\"/></Peers><ParticipantIndex>auto</ParticipantIndex>"
          + "<MaxAutoParticipantIndex>30</MaxAutoParticipantIndex></Discovery></Domain></CycloneDDS>";

  @TempDir static Path folder;

  private static Path ros;
  private static Path dds;
  private static Path generated;

  @BeforeAll
  static void runBoth() throws IOException {
    ros = FinishedRun.in(folder.resolve("ros")).path();
    dds = Program.exampleIn(folder.resolve("dds"));
    Files.writeString(
        dds.resolve("eventchain.yaml"),
        "\ntemplate: cyclonedds-python\n",
        StandardOpenOption.APPEND);
    for (String name :
        List.of(
            "chain.xmi",
            "generated.ocl",
            "components/TTC_Calculation.py",
            "components/Braking_Decision.py")) {
      Path copy = dds.resolve("out").resolve(name);
      Files.createDirectories(copy.getParent());
      Files.copy(ros.resolve("out").resolve(name), copy);
    }
    new Program()
        .run("run", dds, "--from", "generate")
        .expect(0)
        .says("PASSED: 2 of 2 scenarios passed");
    generated = dds.resolve("out/cyclonedds/aeb");
  }

  @Test
  void theSimulationMeasuresTheSameAsOfTheNodesOfRos() throws IOException {
    for (String name : List.of("verdict.json", "chain.measured.xmi")) {
      assertArrayEquals(
          Files.readAllBytes(ros.resolve("out").resolve(name)),
          Files.readAllBytes(dds.resolve("out").resolve(name)),
          name);
    }
    assertEquals(measurements(ros), measurements(dds));
  }

  private static JsonNode measurements(Path project) throws IOException {
    JsonNode json = new ObjectMapper().readTree(project.resolve("out/measurements.json").toFile());
    return ((ObjectNode) json).without("host");
  }

  @Test
  void thereIsNoCodeOfRosInThePackage() throws IOException {
    try (Stream<Path> files = Files.walk(generated)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        assertTrue(!Files.readString(file).contains("rclpy"), file.toString());
      }
    }
    assertTrue(Files.notExists(dds.resolve("out/ros2")));
  }

  @Test
  void thePackageNeedsWhatItsComponentsImport() throws IOException {
    String project = Files.readString(generated.resolve("pyproject.toml"));
    assertTrue(project.contains("\", \"numpy\"]"), project);
  }

  @Test
  void thePackagePassesItsOwnTests() throws IOException {
    python(generated, "-m", "pytest", "-q", "-p", "no:cacheprovider").expect(0).says("10 passed");
  }

  @Test
  void aForkAndAJoinPassTheirOwnTests() throws IOException {
    forkAndJoin("fork");
    python(folder.resolve("fork"), "-m", "pytest", "-q", "-p", "no:cacheprovider")
        .expect(0)
        .says("9 passed");
  }

  /** Speeds, percentages, temperatures and angles, as messages have them and as components do. */
  @Test
  void unitsAreConvertedAtTheEndsOfTheWire() throws IOException {
    copyCase("units/expected/limiter", "units", List.of("Limiter", "Warning"));
    python(folder.resolve("units"), "-m", "pytest", "-q", "-p", "no:cacheprovider")
        .expect(0)
        .says("6 passed");
  }

  @Test
  void thePackagesAreFreeOfLint() throws IOException {
    forkAndJoin("lint");
    for (Path each : List.of(generated, folder.resolve("lint"))) {
      python(each, "-m", "ruff", "check", "--no-cache", ".").expect(0);
      // Components exchange Any; they themselves are not generated from templates.
      List<String> hints = List.of("--extend-select", "ANN,E501", "--ignore", "ANN401");
      Stream<String> words =
          Stream.of("-m", "ruff", "check", "--no-cache", "--exclude", "components", ".");
      python(each, Stream.concat(words, hints.stream()).toArray()).expect(0);
    }
  }

  @Test
  void bytesOnTheWireAreThoseOfRos() throws IOException {
    forkAndJoin("wire");
    Path runtime = Program.ROOT.resolve("bundles/robot/runtime/python");
    String written = new Program().run("messages", RESOURCES.resolve("msg")).expect(0).out();
    Path messages = Files.writeString(folder.resolve("messages.json"), written);
    python(folder.resolve("wire"), RESOURCES.resolve("wire.py"), runtime, messages)
        .expect(0)
        .says("10 messages are the same");
  }

  @Test
  void aValueCrossesTwoProcessesAndComesOutAsExpected() throws Exception {
    String domain = Long.toString(1 + ProcessHandle.current().pid() % 90);
    List<Process> nodes = new ArrayList<>();
    List<Path> logs = new ArrayList<>();
    try {
      for (String module : List.of("aeb.ttc_calculation_node", "aeb.braking_decision_node")) {
        Path log = folder.resolve(module + ".log");
        logs.add(log);
        nodes.add(
            builder(generated, domain, "-m", module)
                .redirectErrorStream(true)
                .redirectOutput(log.toFile())
                .start());
      }
      // Below 8 m at 8 m/s it is less than 1 s, and the vehicle brakes with full force.
      ended(builder(generated, domain, RESOURCES.resolve("peer.py")))
          .expect(0)
          .says("seen: brake_force, time_to_collision");
      for (Process node : nodes) {
        assertTrue(node.isAlive(), logs::toString);
        node.destroy();
        assertTrue(node.waitFor(10, TimeUnit.MINUTES), "the node ends when it is told to");
        assertEquals(0, node.exitValue(), Files.readString(logs.get(nodes.indexOf(node))));
      }
    } finally {
      nodes.forEach(Process::destroyForcibly);
    }
  }

  /** The package of the fork example, with components that need no answers. */
  private static void forkAndJoin(String name) throws IOException {
    copyCase("fork-and-join/expected/fork", name, List.of("Source", "Left", "Right", "Join"));
  }

  private static void copyCase(String case_, String name, List<String> components)
      throws IOException {
    Path generated = CASES.resolve(case_);
    Path copy = folder.resolve(name);
    try (Stream<Path> files = Files.walk(generated)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Path target = copy.resolve(generated.relativize(file).toString());
        Files.createDirectories(target.getParent());
        Files.copy(file, target);
      }
    }
    for (String component : components) {
      Files.writeString(
          copy.resolve(generated.getFileName() + "/components").resolve(component + ".py"),
          "class " + component + ":\n    pass\n");
    }
  }

  private static Program.Ended python(Path package_, Object... arguments) throws IOException {
    return ended(builder(package_, "0", arguments));
  }

  private static ProcessBuilder builder(Path package_, String domain, Object... arguments)
      throws IOException {
    List<String> command = new ArrayList<>(List.of(Environment.executable()));
    Stream.of(arguments).map(String::valueOf).forEach(command::add);
    ProcessBuilder builder = new ProcessBuilder(command).directory(package_.toFile());
    builder.environment().put("PYTHONPATH", package_.toString());
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    builder.environment().put("CYCLONEDDS_URI", LOOPBACK);
    builder.environment().put("ROS_DOMAIN_ID", domain);
    return builder;
  }

  private static Program.Ended ended(ProcessBuilder builder) throws IOException {
    Path out = Files.createTempFile(folder, "python", ".out");
    Path err = Files.createTempFile(folder, "python", ".err");
    Process process = builder.redirectOutput(out.toFile()).redirectError(err.toFile()).start();
    try {
      if (!process.waitFor(30, TimeUnit.MINUTES)) {
        throw new AssertionError("still running: " + Files.readString(err, UTF_8));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    } finally {
      process.destroyForcibly();
    }
    return new Program.Ended(process.exitValue(), Files.readString(out), Files.readString(err));
  }

  /** The environment with Cyclone DDS, created for the first test that needs it. */
  private static final class Environment {
    private static final Program.Ended FOUND = make();

    private static String executable() {
      assumeTrue(
          FOUND.code() != 3 && FOUND.code() != 4,
          () -> "Cyclone DDS cannot be installed: " + FOUND.err());
      return FOUND.expect(0).out().strip();
    }

    private static Program.Ended make() {
      try {
        return ended(
            new ProcessBuilder(
                "python3",
                ENVIRONMENT.toString(),
                "--development",
                "--cyclonedds",
                "--print-executable"));
      } catch (IOException e) {
        throw new java.io.UncheckedIOException(e);
      }
    }
  }
}

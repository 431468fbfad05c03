package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests nodes as processes on Cyclone DDS: the same verdicts as in lock-step, in one scenario of
 * one example by default, another one each day, and in all of all examples in the profile {@code
 * thorough}.
 */
class DdsDriverTest {

  private static final int SCENARIOS = Integer.getInteger("driver.scenarios", 1);
  private static final String HOST = "eventchain_ros2.node_host";

  /**
   * Script that enables the loopback interface of a new network namespace, and executes a program.
   */
  private static final String LOOPBACK_UP =
      "import fcntl, os, socket, struct, sys;"
          + "up = struct.pack('16sH14x', b'lo', 1);"
          + "fcntl.ioctl(socket.socket(), 0x8914, up);"
          + "os.execvp(sys.argv[1], sys.argv[1:])";

  @TempDir private Path folder;

  /** In radar-fails timers of two nodes fire at the same moments, one of them for the other. */
  static Stream<Arguments> examples() {
    return Thorough.allOrOne(
        List.of(
            arguments("aeb", "stopped-vehicle-50", "ros2-python"),
            arguments("aeb", "stopped-vehicle-50", "cyclonedds-python"),
            arguments("acc", "radar-fails", "ros2-python"),
            arguments("lane-departure", "drift-left", "ros2-python")))
        .stream();
  }

  @ParameterizedTest
  @MethodSource("examples")
  void sameVerdictAndMeasurementsAsInLockstep(String example, String scenario, String template)
      throws IOException {
    Path project = copy(example, scenario);
    Files.writeString(
        project.resolve("eventchain.yaml"),
        "\ntemplate: " + template + "\n",
        StandardOpenOption.APPEND);
    Program.Ended lockstep = new Program().run("run", project);
    List<String> verdicts = verdicts(lockstep);
    assertTrue(!verdicts.isEmpty(), lockstep.err());
    String measured = measurements(project);
    Program.Ended dds = new Program().run("simulate", project, "--driver", "dds");
    assertEquals(lockstep.code(), dds.code(), dds.err());
    assertEquals(verdicts, verdicts(dds));
    assertEquals(measured, measurements(project));
    Program.requireBoundsHold(project);
  }

  /** Returns the example with this scenario, or with all of them. */
  private Path copy(String example, String scenario) throws IOException {
    ProjectCopy copy = ProjectCopy.of(example, folder);
    if (SCENARIOS == 1) {
      copy.onlyScenario("scenarios/" + scenario + ".yaml");
    }
    return copy.path();
  }

  private static List<String> verdicts(Program.Ended ended) {
    return Stream.concat(ended.out().lines(), ended.err().lines())
        .filter(line -> line.matches("(passed|failed|untested|PASSED|FAILED|INCOMPLETE)\\b.*"))
        .toList();
  }

  /** Returns everything that does not depend on the machine. */
  private static String measurements(Path project) throws IOException {
    ObjectMapper json = new ObjectMapper();
    ObjectNode all = (ObjectNode) json.readTree(project.resolve("out/measurements.json").toFile());
    return all.without("host").toPrettyString();
  }

  @InTurn
  @Test
  void noNetworkIsNeededButLoopback() throws Exception {
    String[] alone = {"unshare", "--map-root-user", "--net", "python3", "-c", LOOPBACK_UP};
    assumeTrue(works(alone, "true"), "no network namespace can be made here");
    Path project = copy("lane-departure", "drift-left");
    new Program().run("run", project, "--to", "generate").expect(0);
    new Program()
        .by(alone)
        .run("simulate", project, "--driver", "dds", "--scenario", "drift-left")
        .expect(0)
        .says("passed  drift-left");
  }

  private static boolean works(String[] command, String program) throws Exception {
    try {
      List<String> line = Stream.concat(Stream.of(command), Stream.of(program)).toList();
      return new ProcessBuilder(line).start().waitFor() == 0;
    } catch (IOException e) {
      return false;
    }
  }

  @Test
  void noNodeLivesWhenTheProgramIsKilled() throws Exception {
    Path project = copy("lane-departure", "drift-left");
    new Program().run("run", project, "--to", "generate").expect(0);
    Path out = folder.resolve("out");
    Path err = folder.resolve("err");
    Process program =
        new Program()
            .start(out, err, "simulate", project, "--driver", "dds", "--scenario", "drift-left");
    List<ProcessHandle> hosts = List.of();
    while (hosts.size() < 4 && program.isAlive()) {
      hosts = program.descendants().filter(DdsDriverTest::isHost).toList();
      Thread.sleep(2);
    }
    assertTrue(program.isAlive(), () -> "it ended before it could be killed");
    program.destroyForcibly().waitFor();
    for (ProcessHandle host : hosts) {
      host.onExit().get(120, TimeUnit.SECONDS);
    }
  }

  private static boolean isHost(ProcessHandle handle) {
    return handle.info().commandLine().orElse("").contains(HOST);
  }

  @Test
  void doctorSaysThatNodesCanRunOnDds() {
    Program.Ended doctor = new Program().run("doctor");
    assertTrue(
        doctor
            .out()
            .lines()
            .anyMatch(line -> line.matches("Cyclone DDS +fine +for .*dds: .*packages are there")),
        doctor.out());
  }

  @Test
  void realTimeWithoutDdsIsWrongUsage() throws IOException {
    new Program()
        .run("simulate", copy("lane-departure", "drift-left"), "--real-time")
        .expect(2)
        .says("--real-time needs --driver dds");
  }

  @Test
  void driverThatDoesNotExistIsWrongUsage() {
    new Program().run("simulate", folder, "--driver", "corba").expect(2).says("--driver");
  }
}

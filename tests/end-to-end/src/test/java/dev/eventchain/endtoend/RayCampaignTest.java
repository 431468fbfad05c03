package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Thorough;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests campaigns on Ray clusters. */
class RayCampaignTest {

  private static final Map<String, String> TOKEN =
      Map.of("RAY_AUTH_MODE", "token", "RAY_AUTH_TOKEN", "0123456789abcdef".repeat(4));
  private static final Path SANDBOX =
      Program.ROOT.resolve("bundles/robot/sandbox/src/main/resources/dev/eventchain/sandbox");

  @TempDir Path folder;
  private ProjectCopy copy;
  private Path campaign;

  @BeforeEach
  void copyTheExample() throws IOException {
    copy = ProjectCopy.of("radar-aeb", folder);
    copy.write(
        "approach.yaml",
        """
        scenario: stopped-vehicle-50
        factors:
          speed: {path: ego.speed_kmh, from: 40, to: 50, step: 2}
          gap: {path: "actors[0].gap_m", from: 15, to: 60, step: 15}
        """);
    campaign = copy.path().resolve("approach.yaml");
  }

  @Test
  void theEngineIsRayForWholeCampaigns() {
    new Program()
        .run("campaign", copy.path(), campaign, "--engine", "spark")
        .expect(2)
        .says("--engine ray=ADDRESS");
    for (String other : List.of("--shard=1/2", "--case=1", "--dry-run")) {
      new Program()
          .run("campaign", copy.path(), campaign, "--engine", "ray", other)
          .expect(2)
          .says("--engine is for the whole campaign");
    }
    new Program()
        .run("campaign", copy.path(), campaign, "--engine=ray", "--merge", folder)
        .expect(2)
        .says("--merge stands alone");
  }

  @Test
  void aNodeThatIsKilledHalfWayChangesNothing() throws Exception {
    assumeTrue(Thorough.IS_ON, "downloads Ray, and takes a minute");
    new Program().run("campaign", copy.path(), campaign).expect(1).says("24 cases: ");
    List<byte[]> expected = results();
    Files.delete(result("cases.json"));
    Process cluster = cluster();
    try (BufferedReader said = cluster.inputReader();
        Writer input = cluster.outputWriter()) {
      String address = said.readLine();
      Path err = folder.resolve("err.txt");
      Process process = start("ray=" + address, err);
      while (process.isAlive() && !Files.exists(result("parts/000001.json"))) {
        Thread.sleep(20);
      }
      assertTrue(process.isAlive(), () -> text(err));
      input.write("kill\n");
      input.flush();
      assertEquals("killed", said.readLine());
      assertTrue(process.isAlive(), "it ended before the node did");
      assertTrue(process.waitFor(Program.LONGEST_SECONDS, TimeUnit.SECONDS));
      assertEquals(1, process.exitValue(), () -> text(err));
      List<byte[]> found = results();
      for (int i = 0; i < expected.size(); i++) {
        assertArrayEquals(expected.get(i), found.get(i));
      }
    } finally {
      cluster.waitFor(60, TimeUnit.SECONDS); // It ends with its input.
      cluster.descendants().forEach(ProcessHandle::destroyForcibly);
      cluster.destroyForcibly();
    }
  }

  /** The driver, the cluster, and the parts on it. */
  @Test
  void anInterruptLosesNothingAndLeavesNoProcess() throws Exception {
    assumeTrue(Thorough.IS_ON, "downloads Ray, and takes a minute");
    new Program().run("campaign", copy.path(), campaign).expect(1).says("24 cases: ");
    List<byte[]> expected = results();
    Files.delete(result("cases.json"));
    Path err = folder.resolve("err.txt");
    Path out = folder.resolve("out.txt");
    Process process =
        new Program()
            .by("env", "--default-signal=INT")
            .start(out, err, "campaign", copy.path(), campaign, "--engine", "ray");
    while (process.isAlive() && !Files.exists(result("parts/000001.json"))) {
      Thread.sleep(5);
    }
    assertEquals(130, Program.interrupt(process), () -> text(err));
    new Program().run("campaign", copy.path(), campaign).expect(1).says("24 cases: ");
    assertArrayEquals(expected.get(1), results().get(1));
  }

  /**
   * A cluster of this machine, a component that only a shipped file tells apart, and no cluster.
   */
  @Test
  void withoutAnAddressTheClusterIsThisMachine() throws Exception {
    assumeTrue(Thorough.IS_ON, "downloads Ray, and takes a minute");
    new Program()
        .run("campaign", copy.path(), campaign, "--engine", "ray=127.0.0.1:9")
        .expect(3)
        .says("[campaign.engine]")
        .says("There is no Ray cluster at '127.0.0.1:9'");
    copy.write(".venv/secret.txt", "not for others");
    new Program()
        .run("campaign", copy.path(), campaign, "--engine", "ray")
        .expect(1)
        .says("24 cases: ");
    assertFalse(isShipped(".venv/secret.txt"));
    assertTrue(isShipped("eventchain.yaml"));
    List<byte[]> found = results();
    assertFalse(Files.exists(result("parts")));
    Files.delete(result("cases.json"));
    new Program().run("campaign", copy.path(), campaign).expect(1);
    assertArrayEquals(results().get(1), found.get(1));
  }

  /** One after the other, one of them of a file in OpenSCENARIO XML beside the campaign file. */
  @Test
  void severalCampaignsAndPlayedFilesAreSent() throws Exception {
    assumeTrue(Thorough.IS_ON, "downloads Ray, and takes a minute");
    Projects.copy(
        Program.ROOT.resolve("bundles/robot/simulation/src/test/resources/openscenario"),
        copy.path().resolve("files"));
    copy.write(
        "both.yaml",
        """
        campaigns:
          near:
            scenario: stopped-vehicle-50
            factors:
              gap: {path: "actors[0].gap_m", from: 15, to: 60, step: 15}
          played:
            scenario: files/rear-end-cases.xosc
            accept: [no_impact]
        """);
    Path both = copy.path().resolve("both.yaml");
    Path results = copy.path().resolve("out/campaigns");
    Program.Ended alone = new Program().run("campaign", copy.path(), both);
    List<byte[]> expected = tables(results);
    for (String name : List.of("near", "played")) {
      Files.delete(results.resolve("both-" + name + "/cases.json"));
    }
    Program.Ended sent = new Program().run("campaign", copy.path(), both, "--engine", "ray");
    assertEquals(alone.out(), sent.out());
    assertArrayEquals(expected.toArray(), tables(results).toArray());
  }

  private static List<byte[]> tables(Path results) throws IOException {
    List<byte[]> tables = new ArrayList<>();
    for (String name : List.of("near", "played")) {
      tables.add(Files.readAllBytes(results.resolve("both-" + name + "/cases.csv")));
    }
    return tables;
  }

  /** Returns whether a node has got a file of the project, at its place below a pack's folder. */
  private boolean isShipped(String name) throws IOException {
    Path place = Path.of("/").relativize(copy.path().toAbsolutePath().resolve(name));
    String home = System.getenv().getOrDefault("XDG_CACHE_HOME", System.getenv("HOME") + "/.cache");
    try (Stream<Path> packs = Files.list(Path.of(home, "eventchain/ray"))) {
      return packs.anyMatch(pack -> Files.exists(pack.resolve(place)));
    }
  }

  private Process start(String engine, Path err) throws IOException {
    Program program = new Program();
    TOKEN.forEach(program::with);
    Path out = folder.resolve("out.txt");
    return program.start(out, err, "campaign", copy.path(), campaign, "--engine", engine);
  }

  private Process cluster() throws IOException {
    List<String> command = new ArrayList<>(List.of("python3", SANDBOX + "/environment.py"));
    command.addAll(List.of("--ray", "--run", "-B"));
    command.add(Program.ROOT + "/tests/end-to-end/src/test/resources/ray/two_nodes.py");
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().putAll(TOKEN);
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    return builder.redirectError(folder.resolve("cluster.txt").toFile()).start();
  }

  private Path result(String name) {
    return copy.path().resolve("out/campaigns/approach").resolve(name);
  }

  private List<byte[]> results() throws IOException {
    return List.of(
        Files.readAllBytes(result("cases.csv")),
        Files.readAllBytes(result("cases.json")),
        Files.readAllBytes(result("report.html")));
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return e.toString();
    }
  }
}

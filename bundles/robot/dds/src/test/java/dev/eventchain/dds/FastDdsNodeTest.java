package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.sandbox.PythonEnvironment;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import us.ihmc.pubsub.publisher.Publisher;

/**
 * An unchanged generated node on our runtime in its own process. Fast DDS, the default middleware
 * of ROS 2, sends it times to collision and receives brake forces.
 */
class FastDdsNodeTest {

  private static final Path BUNDLES = Path.of("").toAbsolutePath().getParent().getParent();
  private static final Path GENERATED =
      BUNDLES.resolve("mde/m2t/src/test/resources/cases/ros2-python/aeb/expected/aeb");
  private static final String COMPONENT =
      """
      class Braking_Decision:
          def execute(self, ttc):
              return {"brake_force": 1.0 if ttc < 2.5 else 0.25}
      """;

  @TempDir private Path folder;

  @BeforeAll
  static void loadLibrary() {
    Wire.library();
  }

  @Test
  void aGeneratedNodeTalksWithFastDdsInBothDirections() throws Exception {
    int domain = 110 + (int) (ProcessHandle.current().pid() % 100);
    Path log = folder.resolve("node.log");
    Process node = start(domain, log);
    BlockingQueue<Float> forces = new LinkedBlockingQueue<>();
    try (FastDds fastDds = new FastDds(domain)) {
      fastDds.subscribe(
          "rt/vehicle/brake_force",
          new FastDds.NumberType(),
          (force, stamp) -> forces.add(force.data));
      Publisher times = fastDds.publisher("rt/aeb/ttc", new FastDds.NumberType());
      assertEquals(0.25f, answer(times, 9.0f, forces, node, log));
      assertEquals(1.0f, answer(times, 1.5f, forces, node, log));
    } finally {
      node.destroy();
      assertTrue(node.waitFor(Wire.PATIENCE.toSeconds(), TimeUnit.SECONDS), "SIGTERM ends it");
    }
  }

  /** Sends a number until the node answers: at first, endpoints may not have matched. */
  private static float answer(
      Publisher times, float time, BlockingQueue<Float> forces, Process node, Path log)
      throws IOException, InterruptedException {
    forces.clear();
    FastDds.Value value = new FastDds.Value();
    value.data = time;
    float wanted = time < 2.5f ? 1.0f : 0.25f;
    long end = System.nanoTime() + Wire.PATIENCE.toNanos();
    Float force = null;
    while (System.nanoTime() < end && node.isAlive() && (force == null || force != wanted)) {
      times.write(value);
      force = forces.poll(100, TimeUnit.MILLISECONDS);
    }
    assertTrue(force != null, () -> "no answer; the node said: " + text(log));
    return force;
  }

  private static String text(Path log) {
    try {
      return Files.readString(log);
    } catch (IOException e) {
      return e.toString();
    }
  }

  private Process start(int domain, Path log) throws IOException {
    copy(GENERATED, folder.resolve("aeb"));
    Path nodes = folder.resolve("aeb/aeb");
    Files.writeString(nodes.resolve("components/Braking_Decision.py"), COMPONENT);
    String runtime = BUNDLES.resolve("robot/runtime/python").toString();
    String harness =
        BUNDLES.resolve("robot/sandbox/src/main/resources/dev/eventchain/sandbox").toString();
    ProcessBuilder builder =
        new ProcessBuilder(
            PythonEnvironment.ensureWithCycloneDds(line -> {}).executable().toString(),
            "-m",
            "eventchain_ros2",
            nodes.resolve("braking_decision_node.py").toString());
    String path =
        String.join(File.pathSeparator, runtime, harness, folder.resolve("aeb").toString());
    builder.environment().put("PYTHONPATH", path);
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    builder.environment().put("ROS_DOMAIN_ID", Integer.toString(domain));
    String once = "<SPDPInterval>1 s</SPDPInterval>";
    builder.environment().put("CYCLONEDDS_URI", DdsParticipant.loopback(once));
    return builder.redirectErrorStream(true).redirectOutput(log.toFile()).start();
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.toList()) {
        Path target = to.resolve(from.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(target);
        } else {
          Files.copy(file, target);
        }
      }
    }
  }
}

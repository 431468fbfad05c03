package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that the guard of a mobile robot goes from its workspace to a verdict: its topics, rate and
 * limits are parameters in a file, and it commands a speed.
 */
class RobotTest {

  private static final Path AGV = Program.ROOT.resolve("tests/end-to-end/src/test/resources/agv");

  @TempDir private Path folder;

  @InTurn
  @Test
  void theParametersOfARobotsGuardDecide() throws IOException {
    Path project = folder.resolve("guard");
    new Program()
        .run("init", project, "--from-workspace", AGV.resolve("ws"))
        .expect(0)
        .says("software-base/nodes/agv_guard/speed_guard.py");
    Path components = project.resolve("software-base/components.json");
    String described = Files.readString(components);
    assertTrue(described.contains("/robot/front_scan"), described);
    assertTrue(described.contains("\"zones.stop\": 0.6"), described);
    new Program()
        .run("validate", project)
        .expect(1)
        .says("`vehicle` does not say how it follows that: maximal_acceleration_mps2")
        .says("[bench.key.missing]");
    state(project);
    new Program()
        .run("run", project, "--no-strength")
        .expect(0)
        .says("passed  pallet")
        .says("PASSED: 1 of 1 scenarios passed, 2 requirements proved");
    Files.writeString(components, described.replace("\"zones.stop\": 0.6", "\"zones.stop\": 0.0"));
    new Program()
        .run("run", project, "--no-strength")
        .expect(1)
        .says("expected no impact, but found: impact at")
        .says("FAILED: 0 of 1 scenarios passed, 2 requirements violated");
  }

  /** Writes what its people know: the robot, its requirements, and a scenario. */
  private static void state(Path project) throws IOException {
    Files.delete(project.resolve("scenarios/stopped-vehicle.yaml"));
    for (String file : new String[] {"bench.yaml", "requirements.md", "scenarios/pallet.yaml"}) {
      Files.writeString(
          project.resolve(file), Files.readString(AGV.resolve("project").resolve(file)));
    }
    Path chain = project.resolve("model/chain.xmi");
    String written = Files.readString(chain);
    String stated =
        written
            .replace(
                "name=\"Speed_Guard\" ",
                "name=\"Speed_Guard\" satisfies=\"//@requirements.0 //@requirements.1\" ")
            .replaceFirst(
                "<requirements id=\"REQ-1\"[^>]*/>",
                "<requirements id=\"AGV-1\" text=\"The guard shall stop the robot before it touches an"
                    + " obstacle ahead.\"/><requirements id=\"AGV-2\" text=\"The guard shall command no"
                    + " more than 0.3 m/s while an obstacle is nearer than 2 m.\"/>");
    assertNotEquals(written, stated);
    Files.writeString(chain, stated);
  }
}

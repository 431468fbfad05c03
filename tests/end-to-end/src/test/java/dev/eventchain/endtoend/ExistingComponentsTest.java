package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests existing components of the radar example: what their nodes cannot use, or what makes a
 * verdict depend on chance, is found before or beside the verdict, and its sharp twin passes.
 */
class ExistingComponentsTest {

  private static final String WARNING = "software-base/components/Collision_Warning.py";
  private static final String BRAKE = "software-base/components/Brake_Request.py";
  private static final String TRACKING = "software-base/components/Radar_Tracking.py";

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void copyProject() throws IOException {
    project = ProjectCopy.of("radar-aeb", folder);
  }

  private Program.Ended validate() {
    return new Program().run("validate", project.path());
  }

  /** Each edit is found by the validation, with its line, and a run ends before it simulates. */
  @ParameterizedTest(name = "{index}: {1}")
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "class Collision_Warning:|class CollisionWarning:|component.class.missing|7:1|Did you mean 'CollisionWarning'?",
        "def execute(|def run(|component.execute.signature|10:5|Did you mean 'run'?",
        "execute(self, ttc)|execute(self, time_to_collision)|component.execute.signature|10:23|Did you mean 'ttc'?",
        "execute(self, ttc)|execute(self, ttc, gain)|component.execute.signature|10:28|Write it as: def execute(self, ttc):",
        "execute(self, ttc):|execute(self, ttc)|component.syntax|10:27|not valid Python",
        "{\"warns\"|{\"warn\"|component.result.keys|12:17|Did you mean 'warns'?",
      })
  void whatTheNodeCannotUse(String text, String by, String id, String place, String hint)
      throws IOException {
    validate().expect(0);
    project.replace(WARNING, text, by);
    validate().expect(1).says("Collision_Warning.py:" + place + ": error").says(id).says(hint);
    Program.Ended run = project.run();
    run.expect(1).says("Collision_Warning.py:" + place + ": error").says(id);
    assertFalse(run.err().contains(" Simulate "), run.err());
    project.requireNotPassed();
  }

  @Test
  void nodeOfRosIsNoComponent() throws IOException {
    project.write(
        WARNING,
        """
        from rclpy.node import Node


        class Collision_Warning(Node):
            def __init__(self):
                super().__init__("collision_warning")
        """);
    validate().expect(1).says("Collision_Warning.py:4:1: error").says("component.node");
    project.run().expect(1).says("component.node");
    project.requireNotPassed();
    String name = "\"name\": \"Collision_Warning\",";
    project.replace(
        "software-base/components.json",
        name,
        name + " \"implementation\": \"node\", \"node\": {\"class\": \"Collision_Warning\"},");
    name = "name=\"Collision_Warning\"";
    project.replace("model/chain.xmi", name, name + " implementation=\"NODE\"");
    project.write(
        "tests/Collision_Warning.yaml",
        "tests: [{name: near, requirement: RAD-2, inputs: {ttc: 1}, outputs: {warns: true}}]\n");
    Program.Ended hosted = new Program().run("run", project.path(), "--to", "implement");
    hosted
        .expect(1)
        .says("tests/Collision_Warning.yaml: error: 'Collision_Warning' is a node as it is")
        .says("[component.tests.unused]");
    assertFalse(hosted.out().contains("[component.node]"), hosted.out());
    project.requireNotPassed();
  }

  /** A filter by the computer's clock, and its twin that counts calls. */
  @Test
  void clockOfTheComputer() throws IOException {
    String counting =
        """
        class Brake_Request:
            def __init__(self):
                self.since = None
                self.braking = False
                self.now = 0.0

            def execute(self, ttc, closing_speed):
                self.now += 0.02
                if ttc < 1.6:
                    self.since = self.now if self.since is None else self.since
                if self.since is not None and self.now - self.since >= 0.05:
                    self.braking = True
                if closing_speed <= 0.1:
                    self.braking = False
                return {"active": self.braking, "acceleration": -9.0 if self.braking else 0.0}
        """;
    project.write(
        BRAKE, "import time\n" + counting.replace("self.now += 0.02", "self.now = time.time()"));
    validate().expect(1).says("Brake_Request.py:9:25: error: 'time.time'").says("component.clock");
    project.run().expect(1).says("component.clock");
    project.requireNotPassed();
    project.write(BRAKE, counting);
    validate().expect(0);
  }

  /** Noise without a seed, and its twin with the source that a run offers. */
  @Test
  void randomNumbers() throws IOException {
    String noisy =
        """
        import random


        class Collision_Warning:
            def __init__(self, random_source=None):
                self._random = random_source or random.Random(7)

            def execute(self, ttc):
                return {"warns": ttc < 2.6 + self._random.uniform(-0.01, 0.01)}
        """;
    project.write(WARNING, noisy.replace("self._random.uniform", "random.uniform"));
    validate().expect(1).says("Collision_Warning.py:9:45: error").says("component.random");
    project.run().expect(1).says("component.random");
    project.requireNotPassed();
    project.write(WARNING, noisy);
    validate().expect(0);
    project.run().expect(0).says("PASSED");
  }

  /** The order of a set of texts, which no rule finds; the twin is sorted. */
  @InTurn
  @Test
  void orderOfSets() throws IOException {
    String ordered =
        """
        class Radar_Tracking:
            def execute(self, valid, distance, distance_rate):
                names = {"front", "left", "right", "rear", "top", "corner", "near", "far"}
                order = sum(i * len(name) for i, name in enumerate(names)) * 1e-4
                closing = -distance_rate / 3.6 if valid else 0.0
                ttc = distance / closing if closing > 0.1 else 1000.0
                return {"ttc": min(ttc, 1000.0), "closing_speed": closing + order}
        """;
    project.write(TRACKING, ordered);
    project
        .run()
        .expect(1)
        .says("INCOMPLETE")
        .says("driven twice, and 'Radar_Tracking' did not repeat itself after ")
        .says("closing_speed of /aeb/threat was ")
        .says("simulation.not-repeatable");
    project.requireNotPassed();
    project.write(TRACKING, ordered.replace("enumerate(names)", "enumerate(sorted(names))"));
    project.run().expect(0).says("PASSED");
  }

  @Test
  void withoutPythonTheValidationSaysWhatItDidNotCheck() {
    new Program()
        .with("EVENTCHAIN_PYTHON", "/nowhere/python")
        .run("validate", project.path())
        .expect(0)
        .says("warning: The source of 3 Python files was not looked into")
        .says("component.source.unchecked");
  }

  @InTurn
  @Test
  void moduleBesideComponents() throws IOException {
    project.replace(WARNING, "WARNING_TTC = 2.6", "from limits import WARNING_TTC");
    project.write(
        "software-base/components/limits.py", "from values import SECONDS as WARNING_TTC\n");
    project.write("software-base/components/values.py", "SECONDS = 2.6\n");
    project.run().expect(0).says("PASSED");
    Path components = project.path().resolve("out/ros2/radar_aeb/radar_aeb/components");
    assertTrue(Files.readString(components.resolve("__init__.py")).contains("sys.path.append("));
    assertEquals("SECONDS = 2.6\n", Files.readString(components.resolve("values.py")));
    project.write("software-base/components/values.py", "SECONDS = 0.6\n");
    new Program().run("simulate", project.path()).expect(2).says("project.stage.outdated");
    project.run().expect(1).says("FAILED");
    project.write("software-base/components/values.py", "import time\nSECONDS = time.time()\n");
    validate().expect(1).says("values.py:2:16: error").says("component.clock");
    project.run().expect(1).says("component.clock");
    project.requireNotPassed();
  }

  @Test
  void modulesThatAreNotFoundEverywhere() throws IOException {
    String components = "software-base/components/";
    project.replace(WARNING, "WARNING_TTC = 2.6", "import statistics, tools\nWARNING_TTC = 2.6");
    project.write(components + "statistics.py", "LIMIT = 1\n");
    project.write(components + "tools/__init__.py", "LIMIT = 1\n");
    validate()
        .expect(1)
        .says("'statistics' is a module of Python itself")
        .says("'tools' is a folder");
    Files.delete(project.path().resolve(components + "statistics.py"));
    project.replace(WARNING, "import statistics, tools", "import statistics");
    validate().expect(0);
  }
}

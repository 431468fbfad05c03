package dev.eventchain.endtoend;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the example with two controllers and a driver: it passes unchanged, and fails with any
 * defect. One scenario is enough for a defect.
 */
class AccExampleTest {

  private static final String SCENARIO = "scenarios/set-speed-lowered.yaml";

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void copyExample() throws IOException {
    project = ProjectCopy.of("acc", folder);
  }

  @InTurn
  @Test
  void everyRequirementIsProvedFromTheRecordings() throws IOException {
    project
        .run()
        .expect(0)
        .says("PASSED: 21 of 21 scenarios passed, 11 requirements proved")
        .says("0 errors, 0 warnings");
    Program.requireBoundsHold(project.path());
  }

  @InTurn
  @Test
  void brakeThatIsDisconnectedInTheBench() throws IOException {
    project.onlyScenario(SCENARIO);
    project.replace("bench.yaml", "{drives: brake, required: true}", "observed");
    project.replace(
        SCENARIO,
        "  formulas:\n",
        """
          formulas:
            - name: it uses the brake
              judges: {ACC-8: "a brake request"}
              formula: eventually[5, 8] brake > 0.1
        """);
    project
        .run()
        .expect(1)
        .says("it uses the brake")
        .says("was not tested: no component's output changes what it reads.")
        .says("[simulation.criterion.untested]");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void motionThatNobodyProvides() throws IOException {
    String bench = Files.readString(project.path().resolve("bench.yaml"));
    Files.writeString(
        project.path().resolve("bench.yaml"),
        bench.replaceAll("(?s)  /vehicle/motion:.*  /driver/settings:", "  /driver/settings:"));
    project
        .run()
        .expect(1)
        .says("INCOMPLETE: nothing was simulated")
        .says(
            "'Longitudinal_Actuation' reads /vehicle/motion, which no entry of the bench provides.")
        .says("[bench.topic.unconnected]");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void latencyOfMoreThanAMillisecond() throws IOException {
    project.onlyScenario(SCENARIO);
    Files.writeString(
        project.path().resolve("constraints.ocl"),
        """
        context EventChain
          inv PedalsWithinAMillisecond:
            self.measured->forAll(m | m.latency->notEmpty() implies m.latency.maximum <= 1.0)
        """);
    project
        .run()
        .expect(1)
        .says("FAILED")
        .says("constraints.ocl:2:")
        .says("EventChain::PedalsWithinAMillisecond");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void actuationThatIsFrozen() throws IOException {
    project.onlyScenario(SCENARIO);
    project.replace(
        "software-base/components/Longitudinal_Actuation.py",
        "        if not active or math",
        "        active = False\n        if not active or math");
    project
        .run()
        .expect(1)
        .says("FAILED: 0 of 1 scenarios passed")
        .says("ego.speed settles at 90 km/h")
        .says("[simulation.criterion.failed]");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void criterionThatIsAboutNothing() throws IOException {
    project.onlyScenario(SCENARIO);
    project.replace(
        SCENARIO,
        "always ego.speed >= 87 km/h",
        "always (ego.speed > 200 km/h implies throttle <= 0)");
    project
        .run()
        .expect(1)
        .says("INCOMPLETE: 0 of 1 scenarios passed, but not all was tested")
        .says("it never falls far below the set speed")
        .says("[simulation.criterion.untested]");
    project.requireNotPassed();
  }
}

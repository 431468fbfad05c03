package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The example with two controllers and a driver: it passes as it is, and does not when anything is
 * broken. One scenario is enough where something is.
 */
class AccExampleTest {

  private static final String SCENARIO = "scenarios/set-speed-lowered.yaml";

  @TempDir private Path folder;
  private Path project;

  @BeforeEach
  void copyExample() throws IOException {
    project = folder.resolve("acc");
    Program.copy(Program.ROOT.resolve("examples/acc"), project);
  }

  private void replace(String file, String text, String by) throws IOException {
    Path path = project.resolve(file);
    String content = Files.readString(path);
    assertEquals(1, content.split(Pattern.quote(text), -1).length - 1, text);
    Files.writeString(path, content.replace(text, by));
  }

  /** Enough where one criterion tells. */
  private void onlyOneScenario() throws IOException {
    try (Stream<Path> files = Files.list(project.resolve("scenarios"))) {
      for (Path file : files.filter(each -> !project.resolve(SCENARIO).equals(each)).toList()) {
        Files.delete(file);
      }
    }
  }

  private Program.Ended run() {
    return new Program().run("run", project);
  }

  private void notPassed() throws IOException {
    Path verdict = project.resolve("out/verdict.json");
    assertFalse(
        Files.exists(verdict)
            && Files.readString(verdict).contains("\"passed\" : true,\n  \"scenarios"));
  }

  @Test
  void everyRequirementIsProvedFromTheRecordings() {
    run()
        .expect(0)
        .says("PASSED: 19 of 19 scenarios passed, 11 requirements proved")
        .says("0 errors, 0 warnings");
  }

  @Test
  void brakeThatIsDisconnectedInTheBench() throws IOException {
    onlyOneScenario();
    replace("bench.yaml", "{drives: brake, required: true}", "observed");
    run()
        .expect(1)
        .says("it uses the brake")
        .says("was not tested: no component's output changes what it reads.")
        .says("[simulation.criterion.untested]");
    notPassed();
  }

  @Test
  void motionThatNobodyProvides() throws IOException {
    String bench = Files.readString(project.resolve("bench.yaml"));
    Files.writeString(
        project.resolve("bench.yaml"),
        bench.replaceAll("(?s)  /vehicle/motion:.*  /driver/settings:", "  /driver/settings:"));
    run()
        .expect(1)
        .says("INCOMPLETE: nothing was simulated")
        .says(
            "'Longitudinal_Actuation' reads /vehicle/motion, which no entry of the bench provides.")
        .says("[bench.topic.unconnected]");
    notPassed();
  }

  @Test
  void latencyOfMoreThanAMillisecond() throws IOException {
    onlyOneScenario();
    Files.writeString(
        project.resolve("constraints.ocl"),
        """
        context EventChain
          inv PedalsWithinAMillisecond:
            self.measured->forAll(m | m.latency->notEmpty() implies m.latency.maximum <= 1.0)
        """);
    run()
        .expect(1)
        .says("FAILED")
        .says("constraints.ocl:2:")
        .says("EventChain::PedalsWithinAMillisecond");
    notPassed();
  }

  @Test
  void actuationThatIsFrozen() throws IOException {
    onlyOneScenario();
    replace(
        "software-base/components/Longitudinal_Actuation.py",
        "        if not active or math",
        "        active = False\n        if not active or math");
    run()
        .expect(1)
        .says("FAILED: 0 of 1 scenarios passed")
        .says("ego.speed settles at 90 km/h")
        .says("it uses the brake")
        .says("[simulation.criterion.failed]");
    notPassed();
  }

  @Test
  void criterionThatIsAboutNothing() throws IOException {
    onlyOneScenario();
    replace(
        SCENARIO,
        "always ego.speed >= 87 km/h",
        "always (ego.speed > 200 km/h implies throttle <= 0)");
    run()
        .expect(1)
        .says("INCOMPLETE: 0 of 1 scenarios passed, but not all was tested")
        .says("it never falls far below the set speed")
        .says("[simulation.criterion.untested]");
    notPassed();
  }
}

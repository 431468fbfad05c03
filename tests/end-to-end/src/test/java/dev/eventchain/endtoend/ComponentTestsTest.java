package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests of component tests: proposed and handwritten ones, and their effects. */
class ComponentTestsTest {
  private static final String DECISION = "tests/Braking_Decision.yaml";

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void copyExample() throws IOException {
    project = ProjectCopy.of("aeb", folder);
  }

  private Program.Ended implement() {
    return new Program().run("run", project.path(), "--to", "implement");
  }

  @Test
  void proposedTestsAreRunAndLieInTheOutput() throws IOException {
    implement().expect(0).says("54 component tests passed");
    String proposed = Files.readString(project.path().resolve("out").resolve(DECISION));
    assertTrue(proposed.contains("- name: at the emergency threshold\n"), proposed);
    implement().expect(0).says("= Implement");
  }

  /** Uses the tests that people wrote instead, without a request. */
  @Test
  void testsThatPeopleWroteTakeTheirPlace() throws IOException {
    project.write(
        DECISION,
        """
        tests:
          - {name: full, requirement: AEB-4, inputs: {ttc: 0.99}, outputs: {braking_force: 1}}
        """);
    implement()
        .expect(0)
        .says("40 component tests passed")
        .says("tests/Braking_Decision.yaml:1:1: warning: No test is about AEB-3, none about AEB-5,")
        .says("none with 'ttc' at 1.0, none with 'ttc' just above 1.0,")
        .says("[component.tests.gap]");
    assertFalse(Files.exists(project.path().resolve("out").resolve(DECISION)));
  }

  @Test
  void componentThatFailsATestEndsTheRunWithItsLine() throws IOException {
    project.write(
        DECISION,
        """
        tests:
          - {name: full, requirement: AEB-4, inputs: {ttc: 0.99}, outputs: {braking_force: 1}}
          - {name: half, requirement: AEB-4, inputs: {ttc: 1.5}, outputs: {braking_force: 0.7}}
        """);
    new Program()
        .run("run", project.path())
        .expect(1)
        .says("tests/Braking_Decision.yaml:3:5")
        .says("The test 'half' of AEB-4 fails: 'braking_force' is 0.5, not 0.7, with ttc = 1.5.");
    project.requireNotPassed();
  }

  @Test
  void aComponentWhoseFailureIsAcceptedIsNotAskedForAgain() throws IOException {
    project.write(
        DECISION,
        """
        tests:
          - {name: half, requirement: AEB-4, inputs: {ttc: 1.5}, outputs: {braking_force: 0.7}}
        """);
    project.write(
        "eventchain-suppressions.yaml",
        "[{id: component.test.failed, reason: Too strict., expires: 2027-03-31}]");
    implement("2027-03-31").expect(0).says("✓ Implement");
    implement("2027-03-31").expect(0).says("= Implement").says("1 finding suppressed");
    implement("2027-04-01").expect(1).says("llm.recording.missing");
  }

  private Program.Ended implement(String date) {
    return new Program().run("run", project.path(), "--to", "implement", "--date", date);
  }

  @Test
  void testThatItsRequirementExcludesIsRefused() throws IOException {
    project.write(
        DECISION,
        """
        tests:
          - {name: full, requirement: AEB-4, inputs: {ttc: 1.5}, outputs: {braking_force: 1}}
        """);
    implement()
        .expect(1)
        .says("tests/Braking_Decision.yaml:2:5")
        .says(
            "but AEB-4 says \"Partial brake if 1.0s ≤ TTC < 2.0s\"."
                + " [component.tests.contradiction]");
  }

  @Test
  void existingComponentsAreTestedToo() throws IOException {
    String test =
        """
        tests:
          - {name: all of it, requirement: AEB-6, inputs: {braking_force: 1.0}, outputs: {brake: %s}}
        """;
    project.write("tests/Carla_Vehicle_Control.yaml", test.formatted("1.0"));
    Path component = project.path().resolve("software-base/components/Carla_Vehicle_Control.py");
    String code = Files.readString(component);
    Files.writeString(
        component,
        code.replaceFirst("(?m)^class ", "import os\nfrom limits import HIGHEST\n\n\nclass "));
    project.write("software-base/components/limits.py", "HIGHEST = 1.0\n");
    implement().expect(0).says("55 component tests passed");
    project.write("tests/Carla_Vehicle_Control.yaml", test.formatted("0.5"));
    implement()
        .expect(1)
        .says("tests/Carla_Vehicle_Control.yaml:2:5")
        .says("'brake' is 1.0, not 0.5, with braking_force = 1.0. [component.test.failed]");
  }

  /** The tests run again when the component changes, or another file that it imports. */
  @InTurn
  @Test
  void existingComponentsAreTestedAsTheyStand() throws IOException {
    project.write(
        "tests/Carla_Vehicle_Control.yaml",
        """
        tests:
          - {name: all of it, requirement: AEB-6, inputs: {braking_force: 1.0}, outputs: {brake: 1.0}}
        """);
    String component = "software-base/components/Carla_Vehicle_Control.py";
    String code = Files.readString(project.path().resolve(component));
    project.write(component, code.replaceFirst("(?m)^class ", "import limits\n\n\nclass "));
    project.write("software-base/components/limits.py", "HIGHEST = 1.0\n");
    implement().expect(0).says("55 component tests passed");
    implement().expect(0).says("= Implement");
    project.write("software-base/components/limits.py", "HIGHEST = 1 / 0\n");
    implement().expect(1).says("Carla_Vehicle_Control");
    project.write("software-base/components/limits.py", "HIGHEST = 1.0\n");
    project.write(component, "class Carla_Vehicle_Control:\n    pass\n");
    implement().expect(1).says("Carla_Vehicle_Control");
    project.write(component, code);
    implement().expect(0).says("55 component tests passed");
  }

  /** Whatever an earlier run found in its own version, the tests run on the current one. */
  @InTurn
  @Test
  void editedComponentsAreTestedAsTheyStand() throws IOException {
    implement().expect(0).says("54 component tests passed");
    String component = "out/components/Braking_Decision.py";
    project.replace(component, "PARTIAL_BRAKE = 0.5", "PARTIAL_BRAKE = 1.0 / 2.0");
    implement()
        .expect(0)
        .says("= Implement")
        .says("54 component tests passed")
        .says("Braking_Decision.py: warning: ")
        .says("[eventchain.file.edited]");
    project.replace(component, "PARTIAL_BRAKE = 1.0 / 2.0", "PARTIAL_BRAKE = 0.7");
    requireFailed(implement());
    requireFailed(new Program().run("run", project.path(), "--to", "implement", "--again"));
    Files.delete(project.path().resolve("out").resolve(DECISION));
    requireFailed(implement()); // by the tests that the model proposes again
    project.replace(component, "PARTIAL_BRAKE = 0.7", "PARTIAL_BRAKE = 0.5");
    implement().expect(0).says("54 component tests passed");
  }

  private static void requireFailed(Program.Ended ended) {
    ended
        .expect(1)
        .says("out/tests/Braking_Decision.yaml:")
        .says("The test 'in the partial range' of AEB-4 fails:")
        .says("'braking_force' is 0.7, not 0.5, with ttc = 1.5. [component.test.failed]")
        .says("39 component tests passed"); // those of the other component
  }

  @InTurn
  @Test
  void editedTestsAreRunAndCounted() throws IOException {
    implement().expect(0).says("54 component tests passed");
    String test = "tests:\n  - {name: full, requirement: %s, inputs: {ttc: %s}, outputs: %s}\n";
    project.write("out/" + DECISION, test.formatted("AEB-4", "0.99", "{braking_force: 1}"));
    implement().expect(0).says("= Implement").says("40 component tests passed").says("tests.gap");
    project.write("out/" + DECISION, test.formatted("AEB-5", "-1.0", "{braking_force: 0.0}"));
    implement()
        .expect(1)
        .says("out/tests/Braking_Decision.yaml:2:5")
        .says("'braking_force' is 1.0, not 0.0")
        .says("39 component tests passed");
    project.write("out/" + DECISION, "tests: []\n");
    implement().expect(1).says("The file contains no test and no property.");
  }

  @Test
  void testsOfAComponentThatThereIsNotAreAFinding() throws IOException {
    project.write("tests/Braking_Decison.yaml", "tests: []\n");
    implement()
        .expect(1)
        .says("The chain has no component 'Braking_Decison', so these tests are not run.")
        .says("Did you mean `Braking_Decision`?")
        .says("[component.tests.unused]");
  }
}

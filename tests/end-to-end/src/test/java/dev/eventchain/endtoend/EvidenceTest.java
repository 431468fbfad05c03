package dev.eventchain.endtoend;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that scenarios that hold without the software, or that end before anything is shown, prove
 * nothing. Each defect stands beside the project that it was made from, which passes.
 */
class EvidenceTest {

  private static final String CONTROLLER = "software-base/components/Lane_Controller.py";
  private static final String LEFT = "scenarios/bend-300-left.yaml";
  private static final String OFFSET = "scenarios/straight-100.yaml";
  private static final String CROSSING = "scenarios/crossing-right-50.yaml";

  @TempDir private Path folder;

  private ProjectCopy project(String fixture) throws IOException {
    Path copy = folder.resolve(fixture);
    Projects.copy(
        Program.ROOT.resolve("tests/end-to-end/src/test/resources").resolve(fixture), copy);
    return new ProjectCopy(Projects.withoutStrength(copy));
  }

  private ProjectCopy laneKeeping() throws IOException {
    return project("lane-keeping");
  }

  private ProjectCopy pedestrianBrake() throws IOException {
    return project("pedestrian-brake");
  }

  @InTurn
  @Test
  void laneKeepingThatSteersProvesItsRequirements() throws IOException {
    laneKeeping().run().expect(0).says("PASSED: 6 of 6 scenarios passed, 9 requirements proved");
  }

  @Test
  void laneKeepingThatNeverSteersDoesNotKeepTheLane() throws IOException {
    ProjectCopy project = laneKeeping();
    project.replace(CONTROLLER, "\"angle\": self._angle", "\"angle\": 0.0");
    project.replace(OFFSET, "lateral_offset_m: 0.8", "lateral_offset_m: 0.1");
    project
        .run()
        .expect(1)
        .says("FAILED  bend-300-left ")
        .says("FAILED  bend-300-right ")
        .says("was not tested: it holds without any command, as the software did not change how");
    project.requireNotPassed();
  }

  @Test
  void runThatEndsByAnImpactShowsNothingOfWhatWasToCome() throws IOException {
    ProjectCopy project = laneKeeping();
    project.replace(LEFT, "accept:", "actors:\n  - {kind: car, gap_m: 1, speed_kmh: 0}\naccept:");
    project.replace(OFFSET, "lateral_offset_m: 0.8", "lateral_offset_m: 0");
    project
        .run()
        .expect(1)
        .says("INCOMPLETE")
        .says("-       bend-300-left ")
        .says("not tested: the run ended after 0.04 s by an impact (the ego's front hit car 1)")
        .says("Scenario bend-300-left ended after 0.04 s of 20.00 s by an impact at 90.0 km/h")
        .says("[simulation.impact.unjudged]")
        .says("'ego.offset settles at 0 m")
        .says("not tested: it holds without any command");
    project.requireNotPassed();
  }

  @Test
  void bandThatCannotBeLeftIsRefused() throws IOException {
    ProjectCopy project = laneKeeping();
    project.replace(OFFSET, "within: 0.2 m", "within: 200 m");
    project
        .run()
        .expect(2)
        .says("straight-100.yaml:8:")
        .says("'abs((ego.offset) - (0 m)) <= 200 m' is true in every run.")
        .says("In this scenario, ego.offset is from -8 to 8 m.")
        .says("[scenario.formula.constant]");
  }

  @InTurn
  @Test
  void pedestrianBrakeThatBrakesProvesItsRequirements() throws IOException {
    pedestrianBrake()
        .run()
        .expect(0)
        .says("PASSED: 8 of 8 scenarios passed, 11 requirements proved");
  }

  @Test
  void formulasThatHoldWhateverTheBrakeDoesAreNotTested() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.onlyScenario(CROSSING);
    project.replace(
        CROSSING,
        "    - name: it brakes with full force\n",
        """
            - formula: eventually[0.2, 7] (ttc < 1 s implies brake > 0.5)
            - formula: always[0.2, 7] not (ttc < 0.001 s and brake < 0.5)
            - formula: always[0.2, 7] (ttc > 0.001 s or brake >= 1)
            - name: it brakes with full force
        """);
    Program.Ended ended = project.run().expect(1);
    for (String formula :
        new String[] {
          "eventually[0.2, 7] (ttc < 1 s implies brake > 0.5)",
          "always[0.2, 7] not (ttc < 0.001 s and brake < 0.5)",
          "always[0.2, 7] (ttc > 0.001 s or brake >= 1)"
        }) {
      ended.says("'" + formula + "' was not tested: it holds whatever is in brake.");
    }
    project.requireNotPassed();
  }

  @Test
  void whatIsNeverDoneAnywhereProvesNoProhibition() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.onlyScenario("scenarios/creeping.yaml");
    project.replace("scenarios/creeping.yaml", "[PCB-9]", "[PCB-4, PCB-9, PCB-11]");
    project.replace(
        "scenarios/creeping.yaml",
        "  never_brakes: true",
        """
          never_brakes: true
          formulas:
            - formula: always[0.3, 7] not /cluster/crossing.unavailable
        """
            .stripTrailing());
    project
        .run()
        .expect(1)
        .says("INCOMPLETE: 0 of 1 scenarios passed")
        .says("'no braking at all' was not tested: it holds for software that does nothing")
        .says("unavailable' was not tested: it holds for software that does nothing");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void whoIsRunOverIsTold() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.replace("scenarios/creeping.yaml", "gap_m: 12", "gap_m: 6");
    project
        .run()
        .expect(1)
        .says("INCOMPLETE: 7 of 8 scenarios passed")
        .says("not tested: the run ended after")
        .says("[simulation.impact.unjudged]")
        .says("consequence: no braking at all");
    project.requireNotPassed();
  }

  @Test
  void singleMomentsAndConstantFormulasAreRefused() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.replace("scenarios/camera-fails.yaml", "always[2, 5]", "always[2, 2]");
    project.replace(CROSSING, "eventually[1, 4] brake >= 0.99", "always brake <= 1");
    project
        .run()
        .expect(2)
        .says("camera-fails.yaml:17:22")
        .says("The interval is a single moment.")
        .says("crossing-right-50.yaml:17:23")
        .says("'brake <= 1' is true in every run.");
  }
}

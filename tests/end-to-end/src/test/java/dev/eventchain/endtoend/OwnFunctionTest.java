package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests a custom function: emergency braking on a radar at 50 Hz, with non-standard messages, a
 * lamp, and an edited chain. The verdict names its defects.
 */
class OwnFunctionTest {

  private static final String CHAIN = "model/chain.xmi";
  private static final String SCENARIO = "scenarios/stopped-vehicle-50.yaml";

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void copyProject() throws IOException {
    project = ProjectCopy.of("radar-aeb", folder);
  }

  @Test
  void allRequirementsAreProved() throws IOException {
    project
        .run()
        .expect(0)
        .says("PASSED: 2 of 2 scenarios passed, 4 requirements proved")
        .says("info: No scenario shows /brake/request.active a second time;")
        .says("[simulation.signal.unshown again]")
        .says("0 errors, 0 warnings");
    new Program()
        .run("bench", project.path())
        .expect(0)
        .says("provides /radar/target (demo_msgs/msg/RadarTarget, 50 Hz) -> Radar_Tracking")
        .says("consumes /cluster/collision_warning (std_msgs/msg/Bool) <- Collision_Warning");
    String path = "Radar_Tracking Brake_Request";
    assertEquals(List.of(path, path), Program.slowestPaths(project.path()));
    Program.requireBoundsHold(project.path());
    assertTrue(
        Files.readString(project.path().resolve("out/report.html")).contains("class=\"passage\""));
  }

  @Test
  void anEditedChainIsValidatedAsItIsWithoutAnEarlierRun() throws IOException {
    String good = "name=\"Brake_Request\"";
    new Program().run("validate", project.path()).expect(0);
    project.replace(CHAIN, good, "name=\"Brake Request\"");
    new Program().run("validate", project.path()).expect(1).says(CHAIN + ":4:");
    project.run().expect(1);
    new Program().run("validate", project.path()).expect(1).says(CHAIN + ":4:");
    project.replace(CHAIN, "name=\"Brake Request\"", good);
    new Program().run("validate", project.path()).expect(0);
  }

  @InTurn
  @Test
  void criterionThatNoComponentCanInfluence() throws IOException {
    project.replace(
        SCENARIO, "  no_impact: true\n", "  no_impact: true\n  maximal_lane_offset_m: 0.5\n");
    project
        .run()
        .expect(1)
        .says("maximal_lane_offset_m")
        .says("was not tested: no component's output changes what it reads.");
    project.requireNotPassed();
  }

  @Test
  void accelerationThatNoVehicleHas() throws IOException {
    project.replace(
        "software-base/components/Brake_Request.py", "FULL_BRAKE = -9.0", "FULL_BRAKE = -900.0");
    project
        .run()
        .expect(1)
        .says("commanded acceleration -900.0")
        .says("[simulation.command.ignored]");
    project.requireNotPassed();
  }

  @Test
  void existingComponentThatTheModelDescribesOtherwise() throws IOException {
    project.replace(CHAIN, "satisfies=\"//@requirements.0\" worstCaseExecutionTime=\"2.0\"", "");
    project
        .run()
        .expect(1)
        .says("model/chain.xmi:3:")
        .says("component 'Radar_Tracking' is '2.0', which the chain does not state.")
        .says("[modeler.component.value.changed]");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void latencyBoundOfAMillisecond() throws IOException {
    project.replace(CHAIN, "maximum=\"100.0\"", "maximum=\"1.0\"");
    project.run().expect(1).says("FAILED").says("radar_to_brake");
    project.requireNotPassed();
  }

  @Test
  void componentThatIsFrozen() throws IOException {
    project.replace(
        "software-base/components/Radar_Tracking.py",
        "return {\"ttc\": min(ttc, NO_COLLISION)",
        "return {\"ttc\": NO_COLLISION");
    project
        .run()
        .expect(1)
        .says("FAILED: 0 of 2 scenarios passed")
        .says("the radar's time to collision is the true one")
        .says("is missed by");
    project.requireNotPassed();
  }

  @Test
  void criterionThatIsVacuous() throws IOException {
    project.replace(SCENARIO, "ttc < 2.5 s implies", "ttc < 2.5 s and ego.speed > 60 km/h implies");
    project
        .run()
        .expect(1)
        .says(
            "INCOMPLETE: 1 of 2 scenarios passed, but not all was tested: 3 requirements proved,"
                + " 1 not tested,")
        .says("the driver is warned")
        .says("[simulation.criterion.untested]");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void signalThatLeavesTheChainIsProvedByACriterionOnItsValueOnly() throws IOException {
    project.replace(
        CHAIN,
        "topicName=\"/cluster/collision_warning\"",
        "topicName=\"/cluster/collision_warning\" external=\"true\""
            + " satisfies=\"//@requirements.1\"");
    project.run().expect(0).says("PASSED: 2 of 2 scenarios passed, 4 requirements proved");
    project.replace(SCENARIO, "/cluster/collision_warning.data", "gap < 80 m");
    project
        .run()
        .expect(1)
        .says("requirements.md:3:")
        .says("No criterion reads /cluster/collision_warning.data, which is an output of the chain")
        .says("[project.requirement.untested RAD-2]")
        .says("INCOMPLETE: 2 of 2 scenarios passed, but not all was tested")
        .says("3 requirements proved, 1 not tested, 1 error");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void requirementThatNoCriterionCanShowToBeMet() throws IOException {
    project.replace(SCENARIO, "/cluster/collision_warning.data", "gap < 80 m");
    project
        .run()
        .expect(1)
        .says("requirements.md:3:")
        .says("No criterion that tests RAD-2 depends on what 'Collision_Warning' writes")
        .says("[project.requirement.untested RAD-2]")
        .says("3 requirements proved, 1 not tested, 1 error");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void criterionThatFailsViolatesWhatItIsAbout() throws IOException {
    project.replace(
        "software-base/components/Collision_Warning.py", "WARNING_TTC = 2.6", "WARNING_TTC = 0.6");
    project
        .run()
        .expect(1)
        .says("FAILED: 1 of 2 scenarios passed, 3 requirements proved, 1 violated");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void requirementThatNoComponentSatisfies() throws IOException {
    project.replace(CHAIN, " satisfies=\"//@requirements.1\"", "");
    project
        .run()
        .expect(1)
        .says("No component of the chain is marked as satisfying RAD-2")
        .says("[project.requirement.untested RAD-2]");
    project.requireNotPassed();
  }

  @Test
  void requirementsOfTheModelThatAreNotThoseOfTheProject() throws IOException {
    project.replace("requirements.md", "is below 2.6 s", "is below 2 s");
    project.replace("scenarios/stopped-vehicle-50.yaml", "is below 2.6 s", "is below 2 s");
    project.replace(CHAIN, "id=\"RAD-4\"", "id=\"RAD-5\"");
    project
        .run()
        .expect(1)
        .says("requirements.md says this about RAD-2: The system shall warn")
        .says("[project.requirement.changed]")
        .says("The model has the requirement 'RAD-5', which requirements.md does not have.")
        .says("[project.requirement.unknown]");
    project.requireNotPassed();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "eventually[0.1, 11.5] (ttc < 2.5 s implies W)",
        "always[0.1, 11.5] not (ttc < 0.1 s and not W)",
        "(ttc < 2.5 s implies W) until[0, 10] ttc < 3 s"
      })
  void formulaThatHoldsWhateverTheComponentSays(String formula) throws IOException {
    replaceWarning(formula);
    project
        .run()
        .expect(1)
        .says("INCOMPLETE")
        .says("it holds whatever is in /cluster/collision_warning.data");
    project.requireNotPassed();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "always[0.1, 11.5] (ttc < 2.5 s implies (ttc > 3 s implies W))",
        "always[0.1, 11.5] (ego.speed >= 0 m/s or W)"
      })
  void formulaThatHoldsInEveryRun(String formula) throws IOException {
    replaceWarning(formula);
    project.run().expect(2).says("INCOMPLETE").says("[scenario.formula.constant]");
    project.requireNotPassed();
  }

  private void replaceWarning(String formula) throws IOException {
    String text = Files.readString(project.path().resolve(SCENARIO));
    Files.writeString(
        project.path().resolve(SCENARIO),
        text.replaceAll(
            "formula: always.*collision_warning.data.*",
            "formula: " + formula.replace("W", "/cluster/collision_warning.data")));
  }

  @InTurn
  @Test
  void aSilentComponentThatPeopleAcceptDoesNotHideTheOthers() throws IOException {
    String chain = Files.readString(project.path().resolve(CHAIN));
    int warned = chain.lastIndexOf("fieldName=\"time_to_collision\"");
    Files.writeString(
        project.path().resolve(CHAIN),
        chain.substring(0, warned) + "maximumAge=\"0.001\" " + chain.substring(warned));
    project.replace(
        "software-base/components/Brake_Request.py", "FULL_BRAKE = -9.0", "FULL_BRAKE = 0.0");
    project.run().expect(1).says("[simulation.node.silent]");
    Files.writeString(
        project.path().resolve("eventchain-suppressions.yaml"),
        """
        - id: simulation.node.silent
          element: Collision_Warning
          reason: The lamp comes later.
          expires: 2027-03-31
        """);
    new Program()
        .run("run", project.path(), "--date", "2026-11-30")
        .expect(1)
        .says("FAILED")
        .says("impact at ");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void requirementThatIsWrittenInAnotherWayIsSaid() throws IOException {
    Path requirements = project.path().resolve("requirements.md");
    String text = Files.readString(requirements) + "5. RAD-5: The system shall stop.\n";
    Files.writeString(requirements, text);
    project
        .run()
        .says("requirements.md:6:4: warning: No item has the id 'RAD-5'.")
        .says("[modeler.requirements.unread]");
  }

  @InTurn
  @Test
  void copyOfAComponentThatSomebodyChangedIsNotSimulatedForIt() throws IOException {
    project.run().expect(0);
    String copy = "out/ros2/radar_aeb/radar_aeb/components/Collision_Warning.py";
    project.replace(copy, "ttc < WARNING_TTC", "True");
    new Program().run("simulate", project.path()).expect(1).says("[eventchain.file.edited]");
    project.requireNotPassed();
    project
        .run()
        .expect(1)
        .says(copy + ": error: This copy differs from ")
        .says("[eventchain.file.edited]");
    project.requireNotPassed();
    new Program().run("run", project.path(), "--overwrite").expect(0).says("PASSED");
  }

  @Test
  void topicsThatFellSilentSayNothingAndTheVehicleKeepsToTheLastCommand() throws IOException {
    project.replace(CHAIN, "fieldName=\"range\"", "fieldName=\"range\" maximumAge=\"100.0\"");
    project.replace("bench.yaml", "rate_hz: 50", "rate_hz: 1.2");
    Files.delete(project.path().resolve("scenarios/short-sight.yaml"));
    Files.writeString(
        project.path().resolve(SCENARIO),
        """
        name: far-away
        title: Nothing near
        requirements: [RAD-1, RAD-2, RAD-3, RAD-4]
        duration_s: 4
        ego: {speed_kmh: 20}
        actors:
          - {gap_m: 100, speed_kmh: 20}
        accept:
          formulas:
            - formula: always[0.2, 4] not /cluster/collision_warning.data
            - formula: always[0.2, 4] /brake/request.acceleration > -1 m/s2
        """);
    project
        .run()
        .expect(1)
        .says("INCOMPLETE")
        .says("since there was no current message on /cluster/collision_warning")
        .says("[simulation.criterion.untested]")
        .says("warning: Scenario far-away: the last command on /brake/request was ")
        .says("and the vehicle still followed it; 100 ms are usual.")
        .says("[simulation.input.too-old]");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void whatPeopleDecidedToLiveWithIsAcceptedByConsoleAndFileAlike() throws IOException {
    project.replace(SCENARIO, "ttc < 2.5 s implies", "ttc < 2.5 s and ego.speed > 60 km/h implies");
    String accepted =
        """
        - id: simulation.criterion.untested
          reason: The test track has no such speed.
          expires: 2027-03-31
        """;
    Files.writeString(project.path().resolve("eventchain-suppressions.yaml"), accepted);
    new Program()
        .run("run", project.path(), "--date", "2026-11-30")
        .expect(1)
        .says("INCOMPLETE")
        .says("Something that RAD-2 depends on could not be judged.")
        .says("[project.requirement.untested RAD-2]");
    project.requireNotPassed();
    Files.writeString(
        project.path().resolve("eventchain-suppressions.yaml"),
        accepted
            + """
            - id: project.requirement.untested
              rule: RAD-*
              reason: The test track has no such speed.
              expires: 2027-03-31
            """);
    new Program()
        .run("run", project.path(), "--date", "2026-11-30")
        .expect(0)
        .says(
            "PASSED: 1 of 2 scenarios passed, 3 requirements proved, 1 not tested, 2 findings suppressed");
    String verdict = Files.readString(project.path().resolve("out/verdict.json"));
    assertTrue(verdict.contains("\"passed\" : true,\n  \"suppressed\" : 2,"), verdict);
    assertTrue(verdict.contains("\"outcome\" : \"not tested\""), verdict);
  }

  @Test
  void formulaOfATopicThatThereIsNot() throws IOException {
    project.replace(SCENARIO, "output(RAD-1, s)", "/aeb/threat.time_to_colision");
    project
        .run()
        .expect(2)
        .says("There is no signal '/aeb/threat.time_to_colision'.")
        .says("Did you mean `/aeb/threat.time_to_collision`?");
    project.requireNotPassed();
  }
}

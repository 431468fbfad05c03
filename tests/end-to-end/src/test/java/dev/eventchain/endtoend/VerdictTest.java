package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the verdict names untested parts, which are neither passed nor failed. */
class VerdictTest {

  @TempDir private Path folder;
  private Path project;

  @BeforeEach
  void copyExample() throws IOException {
    project = Program.exampleIn(folder);
    // One scenario that all requirements name is enough, and quick.
    try (Stream<Path> files = Files.list(project.resolve("scenarios"))) {
      for (Path file : files.filter(each -> !each.endsWith("stopped-vehicle-50.yaml")).toList()) {
        Files.delete(file);
      }
    }
  }

  private void replace(String file, String text, String by) throws IOException {
    String content = Files.readString(project.resolve(file));
    assertTrue(content.contains(text), file);
    Files.writeString(project.resolve(file), content.replace(text, by));
  }

  private Program.Ended run() throws IOException {
    return new Program().run("run", project);
  }

  private void assertNoPass() throws IOException {
    String verdict = Files.readString(project.resolve("out/verdict.json"));
    assertFalse(verdict.contains("\"passed\" : true,\n  \"scenarios"), verdict);
  }

  @Test
  void oneScenarioThatAllRequirementsNameProvesThem() throws IOException {
    run().expect(0).says("PASSED: 1 of 1 scenarios passed");
  }

  @Test
  void criterionWhosePremiseNeverCameTrueIsNotTested() throws IOException {
    replace(
        "scenarios/stopped-vehicle-50.yaml", "  - gap_m:", "  - lateral_offset_m: 5\n    gap_m:");
    replace("scenarios/stopped-vehicle-50.yaml", "  stops: true\n", "");
    replace(
        "scenarios/stopped-vehicle-50.yaml",
        "    stops: {AEB-6: \"command braking force to the actuator\"}\n",
        "");
    run()
        .expect(1)
        .says("INCOMPLETE: 0 of 1 scenarios passed, but not all was tested")
        .says("stopped-vehicle-50.yaml:")
        .says("'no impact' was not tested: nothing ahead.")
        .says("[simulation.criterion.untested]");
    assertNoPass();
  }

  @InTurn
  @Test
  void steeringOffTheRoadFails() throws IOException {
    replace(
        "software-base/components/Carla_Vehicle_Control.py", "\"steer\": 0.0", "\"steer\": 0.5");
    run().expect(1).says("FAILED").says("expected no impact, but found: impact at");
    assertNoPass();
  }

  @InTurn
  @Test
  void brakeThatTheBenchDisconnectsIsNotTested() throws IOException {
    replace(
        "bench.yaml",
        "  /instrument_cluster",
        "  /carla/ego_vehicle/vehicle_control_cmd:\n    observed: true\n  /instrument_cluster");
    run()
        .expect(1)
        .says("INCOMPLETE")
        .says("was not tested: no component's output drives the brake.")
        .says("[simulation.criterion.untested]");
    assertNoPass();
  }

  @Test
  void topicThatTheBenchDoesNotProvideEndsTheRun() throws IOException {
    replace("bench.yaml", "extends: carla\n", "");
    run()
        .expect(1)
        .says("INCOMPLETE: nothing was simulated: 2 errors")
        .says("reads /carla/ego_vehicle/vehicle_status, which no entry of the bench provides.")
        .says(
            "writes /carla/ego_vehicle/vehicle_control_cmd to the vehicle, but the bench does not"
                + " take it.")
        .says("[bench.topic.unconnected]");
    assertNoPass();
  }

  @Test
  void componentThatIsFrozenFails() throws IOException {
    replace(
        "software-base/components/Carla_Vehicle_Control.py",
        "\"brake\": max(0.0, min(1.0, float(braking_force)))",
        "\"brake\": 0.0");
    run().expect(1).says("FAILED").says("no impact, but found: impact at 50.0 km/h");
    assertNoPass();
  }

  @Test
  void throttleBeyondItsRangeIsNotTakenForFullThrottle() throws IOException {
    replace(
        "software-base/components/Carla_Vehicle_Control.py",
        "\"throttle\": 0.0",
        "\"throttle\": 7.0");
    run()
        .expect(1)
        .says("the software commanded throttle 7.0 after")
        .says("[simulation.command.ignored]");
    assertNoPass();
  }

  @Test
  void requirementThatThereIsNotIsFoundBeforeALanguageModelIsAsked() throws IOException {
    replace("scenarios/stopped-vehicle-50.yaml", "AEB-2", "AEB2");
    new Program()
        .run("run", project, "--llm", "handoff:" + folder.resolve("handoff"))
        .expect(1)
        .says("stopped-vehicle-50.yaml:")
        .says("tests 'AEB2', which is not a requirement of this project.")
        .says("[project.requirement.unknown]")
        .says("Did you mean `AEB-2`?");
    assertFalse(Files.exists(folder.resolve("handoff")));
  }

  @Test
  void scenarioThatCannotBeReadIsFoundBeforeALanguageModelIsAsked() throws IOException {
    replace("scenarios/stopped-vehicle-50.yaml", "duration_s", "duration");
    new Program()
        .run("run", project, "--llm", "handoff:" + folder.resolve("handoff"))
        .expect(2)
        .says("[scenario.key.unknown]");
    assertFalse(Files.exists(folder.resolve("handoff")));
  }

  @InTurn
  @Test
  void latencyConstraintBetweenAnyTwoComponentsIsMeasured() throws IOException {
    editModel(
        "</eventchain:EventChain>\n",
        """
          <latencyConstraints name="Tight" first="//@software.1" last="//@software.2" maximum="1"/>
          <latencyConstraints name="All" first="//@software.0" last="//@software.3" maximum="250"/>
        </eventchain:EventChain>
        """);
    run()
        .expect(1)
        .says("FAILED")
        .says("'Tight' allows 1.0 ms from TTC_Calculation to Braking_Decision, but");
    assertEquals(
        List.of(
            "TTC_Calculation Braking_Decision",
            "ObjectDetection TTC_Calculation Braking_Decision Carla_Vehicle_Control"),
        Program.slowestPaths(project));
  }

  @InTurn
  @Test
  void componentThatIsNotSimulatedLeavesWhatDependsOnItUntested() throws IOException {
    editModel("name=\"Braking_Decision\"", "name=\"Braking_Decision\" implementation=\"NODE\"");
    replace(
        "model/chain.xmi",
        "</eventchain:EventChain>\n",
        """
          <latencyConstraints name="Quick" first="//@software.1" last="//@software.2" maximum="500"/>
        </eventchain:EventChain>
        """);
    run()
        .expect(1)
        .says("INCOMPLETE")
        .says("'Carla_Vehicle_Control' never executed: /")
        .says("never arrived; 'Braking_Decision' should have written it.")
        .says("[simulation.node.silent]")
        .says("The latency constraint 'Quick' was not measured in any scenario")
        .says("[simulation.latency.unmeasured]");
    assertNoPass();
  }

  @InTurn
  @Test
  void constraintThatWhatWasMeasuredDecidesProvesItsRequirement() throws IOException {
    editModel(
        "name=\"Braking_Decision\"", "name=\"Braking_Decision\" worstCaseExecutionTime=\"2\"");
    constrain("context ChainMeasurement inv Quick: self.latency.maximum <= 250.0");
    run()
        .expect(1)
        .says("'TTC_Calculation' has no worst-case execution time")
        .says("5 requirements proved, 1 not tested");
    replace(
        "model/chain.xmi",
        "name=\"TTC_Calculation\"",
        "name=\"TTC_Calculation\" worstCaseExecutionTime=\"2\"");
    run().expect(0).says("PASSED: 1 of 1 scenarios passed, 6 requirements proved");
  }

  @Test
  void constraintOnAClassWithoutInstancesIsNotTested() throws IOException {
    constrain("context LatencyConstraint inv Quick: self.maximum <= 250.0");
    run()
        .expect(1)
        .says("INCOMPLETE: 1 of 1 scenarios passed, but not all was tested")
        .says("5 requirements proved, 1 not tested, 1 error")
        .says("constraints.ocl:2:")
        .says(
            "'LatencyConstraint::Quick', which implements AEB-6, was not tested: the measured model"
                + " has no LatencyConstraint.")
        .says("[simulation.rule.untested LatencyConstraint::Quick]");
    assertNoPass();
  }

  @InTurn
  @Test
  void constraintThatIsTrueOfNothingIsNotTestedUnlessPeopleAcceptIt() throws IOException {
    constrain(
        "context ChainMeasurement inv Quick: self.latencies->forAll(l | l.latency.maximum <= 250)");
    run()
        .expect(1)
        .says("INCOMPLETE")
        .says("'ChainMeasurement::Quick', which implements AEB-6, was not tested: it reads")
        .says("[simulation.rule.untested ChainMeasurement::Quick]");
    assertNoPass();
    Files.writeString(
        project.resolve("eventchain-suppressions.yaml"),
        """
        - id: simulation.rule.untested
          rule: ChainMeasurement::Quick
          reason: no latency constraint is in the model yet
          expires: 2999-12-31
        - id: project.requirement.untested
          rule: AEB-6
          reason: no latency constraint is in the model yet
          expires: 2999-12-31
        """);
    run().expect(0).says("PASSED").says("1 not tested, 2 findings suppressed");
  }

  private void constrain(String constraint) throws IOException {
    Files.writeString(
        project.resolve("constraints.ocl"), "-- AEB-6: in time\n" + constraint + "\n");
  }

  private void editModel(String text, String by) throws IOException {
    run().expect(0);
    Files.createDirectories(project.resolve("model"));
    Files.copy(project.resolve("out/chain.xmi"), project.resolve("model/chain.xmi"));
    replace("model/chain.xmi", text, by);
  }
}

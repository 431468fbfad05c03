package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that no earlier verdict passes for one about the current files. */
class StaleVerdictTest {

  private static final String OUTDATED = "project.stage.outdated";

  /** Property that the component does not have, and that no requirement demands. */
  private static final String NEVER_BRAKES =
      "- {name: never, requirement: AEB-5, output: braking_force, over: {ttc: {from: 0, to: 1}},"
          + " within: {at_least: 0, at_most: 0}}";

  @TempDir Path folder;
  private FinishedRun project;

  /** Each test starts from a finished run that has passed. */
  @BeforeEach
  void copyFinishedRun() throws IOException {
    project = FinishedRun.in(folder);
  }

  @ParameterizedTest(name = "{index}: {0} {1}")
  @CsvSource(
      delimiter = '|',
      value = {
        "eventchain.yaml|nam: x|run|2",
        "eventchain-suppressions.yaml|nothing|run|2",
        "eventchain-suppressions.yaml|nothing|simulate|2",
        "requirements.md|- AEB-7: It shall stop.|run --llm handoff:HERE|4",
        "requirements.md|- AEB-7: It shall stop.|simulate|2",
        "scenarios/empty-road.yaml|name: [|run|2",
        "scenarios/empty-road.yaml|# Changed.|simulate --scenario empty-road|0",
        "constraints.ocl|context SoftwareNode inv Fast: frequency > 30|run|1",
        "out/components/Braking_Decision.py|FULL_BRAKE = 0.9|run|1",
        "out/tests/Braking_Decision.yaml|" + NEVER_BRAKES + "|run --to validate|1",
        "software-base/components/ObjectDetection.py|# Changed.|generate|0",
        "requirements.md|- AEB-7: It shall stop.|design --llm handoff:HERE|4",
      })
  void noVerdictOutlivesARunThatReachesNone(String file, String text, String command, int code)
      throws IOException {
    project.append(file, text);
    project.run(command).expect(code);
    project.assertNothingPasses();
  }

  @Test
  void noVerdictOutlivesARunOnAMachineThatLacksSomething() throws IOException {
    new Program()
        .with("EVENTCHAIN_PYTHON", "/nowhere/python3")
        .run("run", project.path(), "--again")
        .expect(3);
    project.assertNothingPasses();
  }

  static Stream<String> stages() {
    return Thorough.allOrOne(List.of("Design", "Generate")).stream();
  }

  @ParameterizedTest
  @MethodSource("stages")
  void noVerdictOutlivesARunThatIsKilled(String stage) throws Exception {
    byte[] passed = Files.readAllBytes(project.out("verdict.json"));
    Path err = folder.resolve("err");
    Process run =
        new Program().start(folder.resolve("out.txt"), err, "run", project.path(), "--again");
    while (run.isAlive() && !Files.readString(err).contains(stage)) {
      Thread.sleep(5);
    }
    assertTrue(run.isAlive(), Files.readString(err));
    run.destroyForcibly().waitFor();
    project.assertNothingPasses();
    project.run("run").expect(0).says("PASSED");
    assertArrayEquals(passed, Files.readAllBytes(project.out("verdict.json")));
  }

  @Test
  void aReportAloneShowsTheVerdictThatStands() throws IOException {
    Files.delete(project.out("report.html"));
    project
        .run("run --from report")
        .expect(0)
        .says("PASSED: 2 of 2 scenarios passed")
        .says("= Simulate");
    String report = Files.readString(project.out("report.html"));
    assertTrue(report.contains("\"verdict\":\"passed\""));
    assertTrue(report.contains("stopped-vehicle-50"));
    project.append("requirements.md", "- AEB-7: It shall stop.");
    project.run("run --from report").expect(2).says(OUTDATED);
    project.assertNothingPasses();
  }

  @Test
  void aReportAloneDoesNotHideAFailure() throws IOException {
    project.append(
        "scenarios/empty-road.yaml", "  formulas: [{formula: always ego.speed < 1 km/h}]");
    project.run("run").expect(1).says("FAILED: 1 of 2");
    byte[] verdict = Files.readAllBytes(project.out("verdict.json"));
    byte[] report = Files.readAllBytes(project.out("report.html"));
    project
        .run("run --from report")
        .expect(1)
        .says("project.verdict.failed")
        .says("1 of 2 scenarios passed")
        .says("FAILED");
    assertArrayEquals(verdict, Files.readAllBytes(project.out("verdict.json")));
    assertArrayEquals(report, Files.readAllBytes(project.out("report.html")));
  }

  @Test
  void aReportAloneNeedsAVerdict() throws IOException {
    FinishedRun.delete(project.path().resolve("out"));
    project.run("run --from report").expect(2).says("project.stage.missing").says("INCOMPLETE");
  }

  @InTurn
  @Test
  void anErrorThatIsNoLongerSuppressedCountsAlsoInALaterStage() throws IOException {
    project.append("constraints.ocl", "context SoftwareNode inv Fast: frequency > 30");
    project.append(
        "eventchain-suppressions.yaml",
        "[{id: ocl.violated, rule: 'SoftwareNode::Fast', reason: Slow., expires: 2027-03-31}]");
    project.run("run --date 2027-03-31").expect(0).says("PASSED");
    project.run("simulate --date 2027-03-31").expect(0).says("PASSED");
    project.run("simulate --date 2027-04-01").expect(2).says(OUTDATED).says("no longer are");
    project.assertNothingPasses();
  }

  @Test
  void aRequirementThatNoScenarioTestsIsNotProvedByAllThatPass() throws IOException {
    try (Stream<Path> scenarios = Files.list(project.path().resolve("scenarios"))) {
      for (Path scenario : scenarios.toList()) {
        Files.writeString(
            scenario,
            Files.readString(scenario)
                .replaceAll("\\{AEB-5: .*}", "{AEB-6: \"command braking force\"}"));
      }
    }
    project
        .run("run")
        .expect(1)
        .says("project.requirement.untested AEB-5")
        .says("requirements.md:7:1");
    assertTrue(project.verdict().contains("\"passed\" : false,"), project.verdict());
    assertTrue(project.verdict().contains("\"AEB-5\""), project.verdict());
    project.append(
        "eventchain-suppressions.yaml",
        "[{id: project.requirement.untested, rule: AEB-5, reason: Soon., expires: 2027-03-31}]");
    project.run("run --date 2027-03-31").expect(0).says("PASSED");
    project.run("run --date 2027-04-01").expect(1).says("project.requirement.untested");
  }

  @ParameterizedTest(name = "{index}: {0}")
  @CsvSource(
      delimiter = '|',
      value = {
        "design-rules.md",
        "constraints.ocl",
        "model/chain.xmi",
        "eventchain-suppressions.yaml",
        "software-base/signals.json",
        "software-base/msg",
      })
  void absentIsOnlyWhatIsNotThere(String file) throws IOException {
    Path path = project.path().resolve(file);
    FinishedRun.delete(path);
    Files.createDirectories(path.getParent());
    Files.createSymbolicLink(path, Path.of("nowhere"));
    project.run("run").expect(2).says("file.").says(file);
    project.assertNothingPasses();
    Files.delete(path);
    if (!file.endsWith("msg")) {
      Files.createDirectory(path);
      project.run("run").expect(2).says("file.unreadable").says(file);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 700})
  void aRuleWithoutItsConstraintIsFound(int bytes) throws IOException {
    byte[] generated = Files.readAllBytes(project.out("generated.ocl"));
    Files.write(project.out("generated.ocl"), java.util.Arrays.copyOf(generated, bytes));
    project.run("run").expect(1).says("project.rule.uncovered DR-3").says("design-rules.md:5:1");
    String report = Files.readString(project.out("report.html"));
    assertFalse(report.matches("(?s).*\"id\":\"DR-3\"[^{]*\"proofs\":\\[\\],\"proved\":true.*"));
    assertTrue(report.matches("(?s).*\"id\":\"DR-3\".*\"proofs\":\\[\\],\"proved\":false.*"));
    project.assertNothingPasses();
    project.run("run --from constrain --overwrite").expect(0).says("PASSED");
  }
}

package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests that no earlier result passes for one about the current files: neither a verdict nor
 * results of stages whose sources have changed.
 */
class StaleResultsTest {

  private static final String OUTDATED = "project.stage.outdated";

  /** Property that the component does not have, and that no requirement demands. */
  private static final String NEVER_BRAKES =
      "- {name: never, requirement: AEB-5, output: braking_force, over: {ttc: {from: 0, to: 1}},"
          + " within: {at_least: 0, at_most: 0}}";

  @TempDir static Path once;
  @TempDir Path folder;

  private static Path finished;
  private Path project;

  @BeforeAll
  static void runOnce() throws IOException {
    finished = Program.exampleIn(once);
    new Program().run("run", finished).expect(0);
  }

  /** Each test starts from a finished run that has passed. */
  @BeforeEach
  void copyFinishedRun() throws IOException {
    project = folder.resolve("aeb");
    copy(finished, project);
    assertTrue(verdict().contains("\"passed\" : true,"));
  }

  private static void copy(Path from, Path to) throws IOException {
    Files.createDirectories(to.getParent());
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.toList()) {
        Path target = to.resolve(from.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(target);
        } else {
          Files.copy(file, target, StandardCopyOption.COPY_ATTRIBUTES);
        }
      }
    }
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
    append(file, text);
    run(command).expect(code);
    assertNothingPasses();
  }

  @Test
  void noVerdictOutlivesARunOnAMachineThatLacksSomething() throws IOException {
    new Program()
        .with("EVENTCHAIN_PYTHON", "/nowhere/python3")
        .run("run", project, "--again")
        .expect(3);
    assertNothingPasses();
  }

  static Stream<String> stages() {
    return Thorough.allOrOne(List.of("Design", "Generate")).stream();
  }

  @InTurn
  @ParameterizedTest
  @MethodSource("stages")
  void noVerdictOutlivesARunThatIsKilled(String stage) throws Exception {
    byte[] passed = Files.readAllBytes(out("verdict.json"));
    Path err = folder.resolve("err");
    Process run = new Program().start(folder.resolve("out.txt"), err, "run", project, "--again");
    while (run.isAlive() && !Files.readString(err).contains(stage)) {
      Thread.sleep(5);
    }
    assertTrue(run.isAlive(), Files.readString(err));
    run.destroyForcibly().waitFor();
    assertNothingPasses();
    run("run").expect(0).says("PASSED");
    assertArrayEquals(passed, Files.readAllBytes(out("verdict.json")));
  }

  @InTurn
  @Test
  void resultsThatStillHoldAreKept() throws IOException {
    byte[] verdict = Files.readAllBytes(out("verdict.json"));
    byte[] measurements = Files.readAllBytes(out("measurements.json"));
    append("requirements.md", "A note for people.");
    run("run --scenario empty-road").expect(0).says("✓ Design");
    assertArrayEquals(verdict, Files.readAllBytes(out("verdict.json")));
    assertTrue(Files.exists(out("report.html")));
    append("requirements.md", "Another note for people.");
    run("run").expect(0).says("✓ Design").says("= Simulate");
    assertArrayEquals(verdict, Files.readAllBytes(out("verdict.json")));
    assertArrayEquals(measurements, Files.readAllBytes(out("measurements.json")));
    run("simulate --scenario empty-road").expect(0);
    assertArrayEquals(verdict, Files.readAllBytes(out("verdict.json")));
    byte[] report = Files.readAllBytes(out("report.html"));
    run("simulate").expect(0);
    assertArrayEquals(report, Files.readAllBytes(out("report.html")));
    append("out/ros2/aeb/setup.py", "# Edited.");
    run("generate --overwrite").expect(0).says("27 files");
    assertArrayEquals(verdict, Files.readAllBytes(out("verdict.json")));
    assertArrayEquals(report, Files.readAllBytes(out("report.html")));
  }

  @ParameterizedTest(name = "{index}: {0} {2}")
  @CsvSource(
      delimiter = '|',
      value = {
        "software-base/components/ObjectDetection.py|# Changed.|simulate|generate",
        "out/components/TTC_Calculation.py|# Changed.|simulate|generate",
        "out/chain.xmi|<!-- Changed. -->|simulate|generate",
        "requirements.md|- AEB-7: It shall stop.|run --from validate|design",
        "requirements.md|- AEB-7: It shall stop.|validate|design",
        "software-base/signals.json|DELETE|run --from validate|design",
        "constraints.ocl|context SoftwareNode inv Fast: frequency > 1|run --from generate|design",
        "eventchain.yaml|package: {license: MIT}|simulate|generate",
        "out/ros2/aeb/aeb/ttc_calculation_node.py|DELETE|simulate|generate",
        "out/generated.ocl|DELETE|run --from validate|constrain",
      })
  void aLaterStageRefusesWhatWasMadeOfOtherFiles(
      String file, String text, String command, String stage) throws IOException {
    append(file, text);
    boolean setting = file.equals("eventchain.yaml");
    String name = setting ? "'package.license'" : file.replaceFirst("^out/", "");
    Program.Ended ended = run(command).expect(2).says(OUTDATED).says(name);
    ended.says("eventchain run " + project + " --from " + stage + "'");
  }

  @InTurn
  @Test
  void theCommandOfTheHintTestsTheEditedComponent() throws IOException {
    String component = "software-base/components/ObjectDetection.py";
    append(component, "# Changed.");
    run("simulate").expect(2).says("ObjectDetection.py").says("--from generate'");
    run("run --from generate").expect(0).says("PASSED");
    assertArrayEquals(
        Files.readAllBytes(project.resolve(component)),
        Files.readAllBytes(out("ros2/aeb/aeb/components/ObjectDetection.py")));
  }

  @Test
  void aReportAloneShowsTheVerdictThatStands() throws IOException {
    Files.delete(out("report.html"));
    run("run --from report").expect(0).says("PASSED: 3 of 3 scenarios passed").says("= Simulate");
    String report = Files.readString(out("report.html"));
    assertTrue(report.contains("\"verdict\":\"passed\""));
    assertTrue(report.contains("stopped-vehicle-50"));
    append("requirements.md", "- AEB-7: It shall stop.");
    run("run --from report").expect(2).says(OUTDATED);
    assertNothingPasses();
  }

  @Test
  void aReportAloneDoesNotHideAFailure() throws IOException {
    append("scenarios/empty-road.yaml", "  formulas: [{formula: always ego.speed < 1 km/h}]");
    run("run").expect(1).says("FAILED: 2 of 3");
    byte[] verdict = Files.readAllBytes(out("verdict.json"));
    byte[] report = Files.readAllBytes(out("report.html"));
    run("run --from report")
        .expect(1)
        .says("project.verdict.failed")
        .says("2 of 3 scenarios passed")
        .says("FAILED");
    assertArrayEquals(verdict, Files.readAllBytes(out("verdict.json")));
    assertArrayEquals(report, Files.readAllBytes(out("report.html")));
  }

  @Test
  void aReportAloneNeedsAVerdict() throws IOException {
    delete(project.resolve("out"));
    run("run --from report").expect(2).says("project.stage.missing").says("INCOMPLETE");
  }

  @Test
  void noReportFileOfAnEarlierCommandSurvives() throws IOException {
    Path file = folder.resolve("report.xml");
    Files.writeString(file, "<testsuites/>");
    run("run --to generate --mcap --report junit=" + file).expect(2);
    assertFalse(Files.exists(file));
  }

  @Test
  void aTemplateInASiblingFolderIsASourceToo() throws IOException {
    for (String set : List.of("ros2-python", "python")) {
      copy(Program.ROOT.resolve("templates").resolve(set), project.resolve("templates/" + set));
    }
    append("eventchain.yaml", "template: templates/ros2-python/main.mtl");
    run("run").expect(0).says("✓ Generate");
    run("run").expect(0).says("= Generate");
    append("templates/python/names.mtl", "Edited.");
    run("run").expect(0).says("✓ Generate");
  }

  @InTurn
  @Test
  void constraintsThatOthersImportAreASourceToo() throws IOException {
    Files.writeString(project.resolve("fast.ocl"), "context SoftwareNode inv Fast: frequency > 1");
    append("constraints.ocl", "import 'fast.ocl'");
    run("run").expect(0).says("PASSED");
    append("fast.ocl", "inv Faster: frequency > 1000");
    run("simulate").expect(2).says(OUTDATED).says("fast.ocl");
    run("run").expect(1).says("Faster");
    assertNothingPasses();
  }

  @InTurn
  @Test
  void aStageThatFailedLeavesNothingToGoOnFrom() throws IOException {
    Path components = project.resolve("software-base/components.json");
    String written = Files.readString(components);
    Files.writeString(components, "[{]");
    run("generate").expect(2);
    Files.writeString(components, written);
    new Program().with("EVENTCHAIN_PYTHON", "/nowhere/python3").run("implement", project).expect(3);
    run("simulate")
        .expect(2)
        .says(OUTDATED)
        .says("'implement' was started")
        .says("--from implement");
    run("run --from implement").expect(0).says("PASSED");
  }

  @Test
  void whatIsKnownToBeOutOfDateCanBeAcceptedForAWhile() throws IOException {
    append("requirements.md", "A note for people.");
    append(
        "eventchain-suppressions.yaml",
        "[{id: project.stage.outdated, reason: No answers yet., expires: 2027-03-31}]");
    run("run --from generate --date 2027-03-31")
        .expect(0)
        .says("PASSED")
        .says("4 findings suppressed");
    run("run --from generate --date 2027-04-01").expect(2).says(OUTDATED);
  }

  @InTurn
  @Test
  void anErrorThatIsNoLongerSuppressedCountsAlsoInALaterStage() throws IOException {
    append("constraints.ocl", "context SoftwareNode inv Fast: frequency > 30");
    append(
        "eventchain-suppressions.yaml",
        "[{id: ocl.violated, rule: 'SoftwareNode::Fast', reason: Slow., expires: 2027-03-31}]");
    run("run --date 2027-03-31").expect(0).says("PASSED");
    run("simulate --date 2027-03-31").expect(0).says("PASSED");
    run("simulate --date 2027-04-01").expect(2).says(OUTDATED).says("no longer are");
    assertNothingPasses();
  }

  @InTurn
  @Test
  void aRequirementThatNoScenarioTestsIsNotProvedByAllThatPass() throws IOException {
    try (Stream<Path> scenarios = Files.list(project.resolve("scenarios"))) {
      for (Path scenario : scenarios.toList()) {
        Files.writeString(
            scenario,
            Files.readString(scenario)
                .replaceAll("\\{AEB-5: .*}", "{AEB-6: \"command braking force\"}"));
      }
    }
    run("run").expect(1).says("project.requirement.untested AEB-5").says("requirements.md:7:1");
    assertTrue(verdict().contains("\"passed\" : false,"), verdict());
    assertTrue(verdict().contains("\"AEB-5\""), verdict());
    append(
        "eventchain-suppressions.yaml",
        "[{id: project.requirement.untested, rule: AEB-5, reason: Soon., expires: 2027-03-31}]");
    run("run --date 2027-03-31").expect(0).says("PASSED");
    run("run --date 2027-04-01").expect(1).says("project.requirement.untested");
  }

  @InTurn
  @Test
  void withoutMemoryNobodyTestsAPackageOfUnknownSources() throws IOException {
    delete(out(".stages"));
    run("simulate").expect(2).says(OUTDATED).says("--from generate'");
    run("run --from generate")
        .expect(0)
        .says("PASSED")
        .says("chain.json, components, chain.xmi, generated.ocl were created from");
    run("run").expect(0).says("PASSED");
    Program.Ended again = run("run --from generate").expect(0);
    assertFalse(again.out().contains(OUTDATED), again.out());
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
    Path path = project.resolve(file);
    delete(path);
    Files.createDirectories(path.getParent());
    Files.createSymbolicLink(path, Path.of("nowhere"));
    run("run").expect(2).says("file.").says(file);
    assertNothingPasses();
    Files.delete(path);
    if (!file.endsWith("msg")) {
      Files.createDirectory(path);
      run("run").expect(2).says("file.unreadable").says(file);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 700})
  void aRuleWithoutItsConstraintIsFound(int bytes) throws IOException {
    byte[] generated = Files.readAllBytes(out("generated.ocl"));
    Files.write(out("generated.ocl"), java.util.Arrays.copyOf(generated, bytes));
    run("run").expect(1).says("project.rule.uncovered DR-3").says("design-rules.md:5:1");
    String report = Files.readString(out("report.html"));
    assertFalse(report.matches("(?s).*\"id\":\"DR-3\"[^{]*\"proofs\":\\[\\],\"proved\":true.*"));
    assertTrue(report.matches("(?s).*\"id\":\"DR-3\".*\"proofs\":\\[\\],\"proved\":false.*"));
    assertNothingPasses();
    run("run --from constrain --overwrite").expect(0).says("PASSED");
  }

  @Test
  void aProjectWithoutDesignRulesKeepsNoneOfTheirConstraints() throws IOException {
    // The prompts contain the rules, so that without them only an edited chain needs no prompt.
    Files.createDirectories(project.resolve("model"));
    Files.copy(out("chain.xmi"), project.resolve("model/chain.xmi"));
    Files.delete(project.resolve("design-rules.md"));
    run("run").expect(0).says("no design rules");
    assertFalse(Files.exists(out("generated.ocl")));
  }

  @InTurn
  @Test
  void lostRecordsOfFilesAreSaidOnce() throws IOException {
    delete(out(".eventchain"));
    append("software-base/components/ObjectDetection.py", "# Changed.");
    Program.Ended ended = run("run").expect(0).says("output.records.damaged");
    assertFalse(ended.out().contains("eventchain.file.edited"), ended.out());
    delete(out(".eventchain"));
    delete(out(".stages"));
    append("out/ros2/aeb/setup.py", "# Changed.");
    append("out/ros2/aeb/aeb/__init__.py", "# Changed.");
    ended = run("run").expect(0).says("output.records.damaged").says(", and 1 more");
    assertEquals(2, ended.out().split("eventchain.file.edited", -1).length, ended.out());
    assertTrue(Files.readString(out("ros2/aeb/setup.py")).endsWith("# Changed.\n"));
  }

  private void assertNothingPasses() throws IOException {
    assertTrue(verdict().contains("\"passed\" : false,"), verdict());
    assertFalse(verdict().contains("true"), verdict());
    for (String name : List.of("measurements.json", "measurements.csv", "chain.measured.xmi")) {
      assertFalse(Files.exists(out(name)), name);
    }
    if (Files.exists(out("report.html"))) {
      assertFalse(Files.readString(out("report.html")).contains("\"verdict\":\"passed\""));
    }
  }

  private Program.Ended run(String command) {
    String[] words = command.replace("HERE", folder.resolve("handoff").toString()).split(" ", -1);
    Object[] arguments = Stream.of(words).toArray();
    Object[] all = new Object[arguments.length + 1];
    all[0] = arguments[0];
    all[1] = project;
    System.arraycopy(arguments, 1, all, 2, arguments.length - 1);
    return new Program().run(all);
  }

  private String verdict() throws IOException {
    return Files.readString(out("verdict.json"));
  }

  private Path out(String name) {
    return project.resolve("out").resolve(name);
  }

  private void append(String file, String text) throws IOException {
    if (text.equals("DELETE")) {
      Files.delete(project.resolve(file));
      return;
    }
    Files.writeString(
        project.resolve(file), text + "\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
  }

  private static void delete(Path path) throws IOException {
    if (!Files.exists(path)) {
      return;
    }
    try (Stream<Path> all = Files.walk(path)) {
      all.sorted(Comparator.reverseOrder())
          .forEach(
              each -> {
                try {
                  Files.delete(each);
                } catch (IOException e) {
                  throw new UncheckedIOException(e);
                }
              });
    }
  }
}

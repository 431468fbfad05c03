package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that no stage goes on from results whose sources have changed. */
class StaleResultsTest {

  private static final String OUTDATED = "project.stage.outdated";

  @TempDir Path folder;
  private FinishedRun project;

  /** Each test starts from a finished run that has passed. */
  @BeforeEach
  void copyFinishedRun() throws IOException {
    project = FinishedRun.in(folder);
  }

  @Test
  void resultsThatStillHoldAreKept() throws IOException {
    byte[] verdict = Files.readAllBytes(project.out("verdict.json"));
    byte[] measurements = Files.readAllBytes(project.out("measurements.json"));
    project.append("requirements.md", "A note for people.");
    project.run("run --scenario empty-road").expect(0).says("✓ Design");
    assertArrayEquals(verdict, Files.readAllBytes(project.out("verdict.json")));
    assertTrue(Files.exists(project.out("report.html")));
    project.append("requirements.md", "Another note for people.");
    project.run("run").expect(0).says("✓ Design").says("= Simulate");
    assertArrayEquals(verdict, Files.readAllBytes(project.out("verdict.json")));
    assertArrayEquals(measurements, Files.readAllBytes(project.out("measurements.json")));
    project.run("simulate --scenario empty-road").expect(0);
    assertArrayEquals(verdict, Files.readAllBytes(project.out("verdict.json")));
    byte[] report = Files.readAllBytes(project.out("report.html"));
    project.run("simulate").expect(0);
    assertArrayEquals(report, Files.readAllBytes(project.out("report.html")));
    project.append("out/ros2/aeb/setup.py", "# Edited.");
    project.run("generate --overwrite").expect(0).says("27 files");
    assertArrayEquals(verdict, Files.readAllBytes(project.out("verdict.json")));
    assertArrayEquals(report, Files.readAllBytes(project.out("report.html")));
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
    project.append(file, text);
    boolean setting = file.equals("eventchain.yaml");
    String name = setting ? "'package.license'" : file.replaceFirst("^out/", "");
    Program.Ended ended = project.run(command).expect(2).says(OUTDATED).says(name);
    ended.says("eventchain run " + project.path() + " --from " + stage + "'");
  }

  @InTurn
  @Test
  void theCommandOfTheHintTestsTheEditedComponent() throws IOException {
    String component = "software-base/components/ObjectDetection.py";
    project.append(component, "# Changed.");
    project.run("simulate").expect(2).says("ObjectDetection.py").says("--from generate'");
    project.run("run --from generate").expect(0).says("PASSED");
    assertArrayEquals(
        Files.readAllBytes(project.path().resolve(component)),
        Files.readAllBytes(project.out("ros2/aeb/aeb/components/ObjectDetection.py")));
  }

  @Test
  void noReportFileOfAnEarlierCommandSurvives() throws IOException {
    Path file = folder.resolve("report.xml");
    Files.writeString(file, "<testsuites/>");
    project.run("run --to generate --mcap --report junit=" + file).expect(2);
    assertFalse(Files.exists(file));
  }

  @Test
  void aTemplateInASiblingFolderIsASourceToo() throws IOException {
    for (String set : List.of("ros2-python", "python")) {
      FinishedRun.copy(
          Program.ROOT.resolve("templates").resolve(set),
          project.path().resolve("templates/" + set));
    }
    project.append("eventchain.yaml", "template: templates/ros2-python/main.mtl");
    project.run("run").expect(0).says("✓ Generate");
    project.run("run").expect(0).says("= Generate");
    project.append("templates/python/names.mtl", "Edited.");
    project.run("run").expect(0).says("✓ Generate");
  }

  @InTurn
  @Test
  void constraintsThatOthersImportAreASourceToo() throws IOException {
    Files.writeString(
        project.path().resolve("fast.ocl"), "context SoftwareNode inv Fast: frequency > 1");
    project.append("constraints.ocl", "import 'fast.ocl'");
    project.run("run").expect(0).says("PASSED");
    project.append("fast.ocl", "inv Faster: frequency > 1000");
    project.run("simulate").expect(2).says(OUTDATED).says("fast.ocl");
    project.run("run").expect(1).says("Faster");
    project.assertNothingPasses();
  }

  @InTurn
  @Test
  void aStageThatFailedLeavesNothingToGoOnFrom() throws IOException {
    Path components = project.path().resolve("software-base/components.json");
    String written = Files.readString(components);
    Files.writeString(components, "[{]");
    project.run("generate").expect(2);
    Files.writeString(components, written);
    new Program()
        .with("EVENTCHAIN_PYTHON", "/nowhere/python3")
        .run("implement", project.path())
        .expect(3);
    project
        .run("simulate")
        .expect(2)
        .says(OUTDATED)
        .says("'implement' was started")
        .says("--from implement");
    project.run("run --from implement").expect(0).says("PASSED");
  }

  @Test
  void whatIsKnownToBeOutOfDateCanBeAcceptedForAWhile() throws IOException {
    project.append("requirements.md", "A note for people.");
    project.append(
        "eventchain-suppressions.yaml",
        "[{id: project.stage.outdated, reason: No answers yet., expires: 2027-03-31}]");
    project
        .run("run --from generate --date 2027-03-31")
        .expect(0)
        .says("PASSED")
        .says("4 findings suppressed");
    project.run("run --from generate --date 2027-04-01").expect(2).says(OUTDATED);
  }

  @InTurn
  @Test
  void withoutMemoryNobodyTestsAPackageOfUnknownSources() throws IOException {
    FinishedRun.delete(project.out(".stages"));
    project.run("simulate").expect(2).says(OUTDATED).says("--from generate'");
    project
        .run("run --from generate")
        .expect(0)
        .says("PASSED")
        .says("chain.json, components, chain.xmi, generated.ocl were created from");
    project.run("run").expect(0).says("PASSED");
    Program.Ended again = project.run("run --from generate").expect(0);
    assertFalse(again.out().contains(OUTDATED), again.out());
  }

  @Test
  void aProjectWithoutDesignRulesKeepsNoneOfTheirConstraints() throws IOException {
    // The prompts contain the rules, so that without them only an edited chain needs no prompt.
    Files.createDirectories(project.path().resolve("model"));
    Files.copy(project.out("chain.xmi"), project.path().resolve("model/chain.xmi"));
    Files.delete(project.path().resolve("design-rules.md"));
    project.run("run").expect(0).says("no design rules");
    assertFalse(Files.exists(project.out("generated.ocl")));
  }

  @InTurn
  @Test
  void lostRecordsOfFilesAreSaidOnce() throws IOException {
    FinishedRun.delete(project.out(".eventchain"));
    project.append("software-base/components/ObjectDetection.py", "# Changed.");
    Program.Ended ended = project.run("run").expect(0).says("output.records.damaged");
    assertFalse(ended.out().contains("eventchain.file.edited"), ended.out());
    FinishedRun.delete(project.out(".eventchain"));
    FinishedRun.delete(project.out(".stages"));
    project.append("out/ros2/aeb/setup.py", "# Changed.");
    project.append("out/ros2/aeb/aeb/__init__.py", "# Changed.");
    ended = project.run("run").expect(0).says("output.records.damaged").says(", and 1 more");
    assertEquals(2, ended.out().split("eventchain.file.edited", -1).length, ended.out());
    assertTrue(Files.readString(project.out("ros2/aeb/setup.py")).endsWith("# Changed.\n"));
  }
}

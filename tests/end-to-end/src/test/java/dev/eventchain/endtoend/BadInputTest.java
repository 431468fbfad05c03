package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests that input errors are reported with location and the right exit code, and that earlier
 * output stays intact.
 */
class BadInputTest {

  private static final String NO_CHAIN =
      "<eventchain:Requirement xmlns:eventchain='http://eventchain.dev/eventchain/1.0'/>";
  private static final String DECISION = "out/components/Braking_Decision.py";

  @TempDir Path folder;

  private Path project;
  private Program.Ended ended;

  /** Each test starts from a finished run. */
  @BeforeEach
  void copyFinishedRun() throws IOException {
    project = FinishedRun.in(folder).path();
  }

  @AfterEach
  void nobodySeesAStackTrace() {
    if (ended != null) {
      assertFalse((ended.out() + ended.err()).contains("\tat "), ended.out() + ended.err());
      assertFalse(ended.err().contains("eventchain.defect"), ended.err());
    }
  }

  @ParameterizedTest(name = "{0} {1} -> {2} {3}")
  @CsvSource(
      delimiter = '|',
      value = {
        "requirements.md|DELETE|1|file.missing|requirements.md",
        "requirements.md|nothing here|2|modeler.requirements.none|requirements.md",
        "eventchain.yaml|name: [|2|project.configuration|eventchain.yaml:2",
        "eventchain.yaml|nam: aeb|2|project.configuration|'nam'",
        "eventchain.yaml|name: ../../x|2|project.configuration|../../x",
        "eventchain.yaml|[aeb]|2|project.configuration|eventchain.yaml:1",
        "eventchain.yaml|{name: aeb, repairs: 2.5}|2|project.configuration|a whole number",
        "eventchain.yaml|{name: aeb, models: {design: }}|2|project.configuration|'design'",
        "software-base/components.json|[{]|2|modeler.json.syntax|components.json:1",
        "software-base/components.json|DELETE|2|file.missing|software-base/components.json",
        "software-base/signals.json|DELETE|2|file.missing|software-base/signals.json",
        "software-base/msg/demo/msg/Bad.msg|float32|2|message.syntax|Bad.msg:1",
        "software-base/signals.json|{}|2|modeler.value.type|signals.json:1",
        "constraints.ocl|context SoftwareNode inv X: self.nam = ''|1|ocl.type|constraints.ocl:1",
        "constraints.ocl|context SoftwareNode inv X: (|1|ocl.syntax|constraints.ocl:1",
        "model/chain.xmi|<a|2|xmi.syntax|chain.xmi:2",
        "model/chain.xmi|" + NO_CHAIN + "|2|project.model|chain.xmi",
        "scenarios/stopped-vehicle-50.yaml|name: [|2|scenario.syntax|stopped-vehicle-50.yaml:2",
      })
  void aBrokenFileIsNamedWithItsPlace(
      String file, String content, int code, String id, String place) throws IOException {
    byte[] before = Files.readAllBytes(project.resolve("out/chain.xmi"));
    Path path = project.resolve(file);
    Files.createDirectories(path.getParent());
    if (content.equals("DELETE")) {
      Files.delete(path);
    } else {
      Files.writeString(path, content + "\n");
    }
    ended = new Program().run("run", project);
    ended.expect(code).says(id).says(place);
    assertFalse((ended.out() + ended.err()).contains("llm.recording"), ended.err());
    assertArrayEquals(before, Files.readAllBytes(project.resolve("out/chain.xmi")));
  }

  @InTurn
  @Test
  void aFileAmongTheScenariosThatIsNoneIsSaidAndOneInAFolderBelowIsSimulated() throws IOException {
    Path scenarios = project.resolve("scenarios");
    Path below = Files.createDirectories(scenarios.resolve("more"));
    Files.move(scenarios.resolve("empty-road.yaml"), below.resolve("empty-road.YML"));
    Files.writeString(scenarios.resolve("cut-in.yaml.txt"), "name: cut-in\n");
    ended = new Program().run("run", project);
    ended.expect(0).says("2 of 2 scenarios").says("scenario.file.unread").says("cut-in.yaml.txt");
    ended = new Program().run("run", project);
    ended.expect(0).says("scenario.file.unread");
  }

  @Test
  void aBrokenTemplateIsNamedWithItsPlace() throws IOException {
    Files.writeString(project.resolve("mine.mtl"), "[module main('x')]\n[template public main(\n");
    Files.writeString(
        project.resolve("eventchain.yaml"),
        "template: mine.mtl\n" + Files.readString(project.resolve("eventchain.yaml")));
    ended = new Program().run("run", project);
    ended.expect(2).says("m2t.").says("mine.mtl:");
  }

  @Test
  void aMissingRecordingSaysWhatChanged() throws IOException {
    Path requirements = project.resolve("requirements.md");
    Files.writeString(
        requirements,
        Files.readString(requirements).replace("or physical lidar", "or physical radar"));
    ended = new Program().run("run", project);
    ended.expect(2).says("llm.recording.missing").says("physical radar").says("handoff:");
  }

  @ParameterizedTest(name = "{index}: {0}")
  @CsvSource(
      delimiter = '|',
      value = {
        "raise ValueError('no')|component.raised",
        "return None|component.result.type",
        "return {'other': 1.0}|component.result.keys",
        "return {'braking_force': float('nan')}|component.result.nan",
        "exec('while True: pass')|component.",
      })
  void aComponentThatMisbehavesIsNamedWithItsLine(String body, String id) throws IOException {
    replaceDecision(body);
    ended = new Program().run("run", project);
    ended.expect(1).says(id).says("Braking_Decision.py:");
  }

  @Test
  void textOfAComponentNeitherSteersTheTerminalNorPassesForAVerdict() throws IOException {
    replaceDecision("raise ValueError('\\x1b[2J\\nPASSED: 7 of 7 scenarios\\n\\u202e')");
    ended = new Program().run("run", project);
    ended.expect(1).says("component.raised").says("\\x1b[2J\\nPASSED: 7 of 7 scenarios\\n\\u202e");
    assertFalse(ended.toString().contains("\u001b"), ended.toString());
    assertFalse(ended.toString().lines().anyMatch(line -> line.strip().startsWith("PASSED")));
  }

  @Test
  void aComponentThatHangsIsStopped() throws IOException {
    replaceDecision("while True: pass");
    ended = new Program().run("run", project, "--scenario", "stopped-vehicle-50");
    ended.expect(1).says("timeout").says("Braking_Decision");
  }

  @Test
  void aComponentThatAlwaysBrakesFailsTheVerdict() throws IOException {
    replaceDecision("return {'braking_force': 1.0}");
    ended = new Program().run("run", project, "--from", "model"); // after its tests
    ended
        .expect(1)
        .says("FAILED")
        .says("simulation.criterion.failed")
        .says("eventchain.file.edited");
  }

  @ParameterizedTest(name = "{index}: {0}")
  @CsvSource({"../../x", "class", "a\"]"})
  void aNameThatIsNoNameIsRefusedBeforeAnythingIsGenerated(String name) throws IOException {
    Path model = project.resolve("model/chain.xmi");
    Files.createDirectories(model.getParent());
    String text = Files.readString(project.resolve("out/chain.xmi"));
    String escaped = name.replace("\"", "&quot;");
    Files.writeString(
        model,
        text.replace("<software name=\"TTC_Calculation\"", "<software name=\"" + escaped + "\""));
    Set<Path> before = filesIn(folder);
    ended = new Program().run("run", project);
    ended.expect(1).says("ocl.violated").says("chain.xmi:");
    Set<Path> after = filesIn(folder);
    after.removeAll(before);
    assertEquals(Set.of(), after, "nothing new, inside or outside of the output");
  }

  @Test
  void aRunThatStopsEarlyProvesNothingWithAnEarlierRun() throws IOException {
    String proved = "\"proved\":true";
    assertTrue(Files.readString(project.resolve("out/report.html")).contains(proved));
    Path requirements = project.resolve("requirements.md");
    String written = Files.readString(requirements);
    Files.writeString(requirements, written.replace("or physical lidar", "or physical radar"));
    ended = new Program().run("run", project);
    ended.expect(2);
    assertFalse(Files.readString(project.resolve("out/report.html")).contains(proved));
    Files.writeString(requirements, written);
    new Program().run("run", project).expect(0).says("✓ Design");
  }

  @Test
  void overwriteReplacesWhatAPersonEdited() throws IOException {
    String generated = Files.readString(project.resolve(DECISION));
    replaceDecision("return {'braking_force': 1.0}");
    ended = new Program().run("run", project, "--overwrite");
    ended.expect(0).says("PASSED");
    assertEquals(generated, Files.readString(project.resolve(DECISION)));
  }

  @Test
  void someScenariosAreNoVerdict() throws IOException {
    byte[] verdict = Files.readAllBytes(project.resolve("out/verdict.json"));
    ended = new Program().run("run", project, "--scenario", "empty-road");
    ended.expect(0).says("1 of 1 scenarios passed; no verdict");
    assertArrayEquals(verdict, Files.readAllBytes(project.resolve("out/verdict.json")));
    new Program()
        .run("run", project, "--scenario", "empty")
        .expect(2)
        .says("project.scenario.unknown")
        .says("stopped-vehicle-50");
  }

  @Test
  void withoutPythonTheMachineLacksSomething() {
    ended =
        new Program().with("EVENTCHAIN_PYTHON", "/nowhere/python3").run("run", project, "--again");
    ended.expect(3).says("python").says("EVENTCHAIN_PYTHON");
  }

  @InTurn
  @Test
  void unknownConfinementIsWrongUsage() {
    ended = new Program().with("EVENTCHAIN_CONFINEMENT", "none").run("run", project, "--again");
    ended.expect(2).says("python.confinement.unknown").says("bubblewrap or audit-hooks");
    ended = new Program().with("EVENTCHAIN_CONFINEMENT", "none").run("run", project);
    ended.expect(2).says("python.confinement.unknown");
  }

  @InTurn
  @Test
  void whatRanUnderAnotherConfinementRunsAgain() {
    new Program().run("run", project).expect(0);
    ended = new Program().with("EVENTCHAIN_CONFINEMENT", "audit-hooks").run("run", project);
    ended.expect(0).says("✓ Simulate").says("times real time, Python audit hooks");
  }

  @Test
  void aLinkOutOfTheOutputFolderIsNotFollowed() throws IOException {
    Path elsewhere = Files.createDirectories(folder.resolve("elsewhere"));
    Path out = Files.createDirectories(folder.resolve("linked"));
    Files.createSymbolicLink(out.resolve("components"), elsewhere);
    ended = new Program().run("run", project, "-o", out);
    ended.expect(1).says("output.path.refused");
    try (Stream<Path> files = Files.list(elsewhere)) {
      assertEquals(0, files.count());
    }
  }

  @Test
  void anEditedVerdictIsReplacedAndThatIsSaid() throws IOException {
    Path verdict = project.resolve("out/verdict.json");
    String written = Files.readString(verdict);
    Files.writeString(verdict, written.replace("true", "false"));
    ended = new Program().run("run", project);
    ended.expect(0).says("eventchain.file.edited").says("PASSED");
    assertEquals(written, Files.readString(verdict));
  }

  @InTurn
  @Test
  void aRunThatIsFoundWantingLeavesNoEarlierVerdictStanding() throws IOException {
    Path verdict = project.resolve("out/verdict.json");
    String passed = Files.readString(verdict);
    Path constraints = project.resolve("constraints.ocl");
    Files.writeString(constraints, "context SoftwareNode inv Fast: self.frequency >= 30.0\n");
    ended = new Program().run("run", project);
    ended.expect(1).says("ocl.violated SoftwareNode::Fast");
    assertTrue(Files.readString(verdict).contains("\"passed\" : false"));
    Files.delete(constraints);
    new Program().run("run", project).expect(0).says("PASSED");
    assertEquals(passed, Files.readString(verdict));
  }

  @Test
  void anOutputThatCannotBeWrittenIsNamed() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "in the way");
    ended = new Program().run("run", project, "-o", file.resolve("out"));
    ended.expect(2).says("output.unwritable").says("-o");
    assertEquals("in the way", Files.readString(file));
  }

  @Test
  void aMissingTemporaryFolderIsNoDefect() throws IOException {
    Path missing = folder.resolve("missing");
    ended =
        new Program()
            .with("JAVA_TOOL_OPTIONS", "-Djava.io.tmpdir=" + missing)
            .run("run", project, "--again");
    ended.expect(3).says("[temporary.unwritable]").says("it does not exist");
    assertFalse(ended.err().contains("Exception"), ended.err());
  }

  @InTurn
  @Test
  void twoRunsDoNotMix() throws Exception {
    Path out = folder.resolve("first.out");
    Path err = folder.resolve("first.err");
    Process first = new Program().haltedAt("Design", out, err, "run", project, "--again");
    try {
      ended = new Program().run("run", project, "--again");
      ended.expect(2).says("output.locked");
    } finally {
      Program.signal(first, "CONT");
    }
    assertEquals(0, first.waitFor(), Files.readString(err));
  }

  static Stream<Arguments> signals() {
    return Thorough.allOrOne(
        List.of(arguments("INT", 130), arguments("TERM", 143), arguments("HUP", 129)))
        .stream();
  }

  @ParameterizedTest
  @MethodSource("signals")
  void anInterruptedRunLeavesWholeFilesAndNoVerdict(String signal, int code) throws Exception {
    byte[] verdict = Files.readAllBytes(project.resolve("out/verdict.json"));
    Path err = folder.resolve("err");
    // A shell that starts tests in the background makes its children ignore interrupts.
    Program program = new Program().by("env", "--default-signal=" + signal);
    Path out = folder.resolve("out.txt");
    Process run = program.haltedAt("Generate", out, err, "run", project, "--again");
    Program.signal(run, signal);
    Program.signal(run, "CONT");
    assertEquals(code, run.waitFor(), Files.readString(err));
    assertTrue(Files.readString(err).contains("interrupted"), Files.readString(err));
    String interrupted = Files.readString(project.resolve("out/verdict.json"));
    assertTrue(interrupted.contains("\"passed\" : false"), interrupted);
    new Program().run("run", project).expect(0).says("PASSED");
    assertArrayEquals(verdict, Files.readAllBytes(project.resolve("out/verdict.json")));
  }

  @ParameterizedTest(name = "{index}: {0}")
  @CsvSource(
      delimiter = '|',
      value = {
        "--nonsense|2|--nonsense",
        "run|2|DIR",
        "run nowhere|2|project.missing",
        "run . --from simulate --to design|2|comes after",
        "run . --to nowhere|2|nowhere",
        "validate --ocl a.ocl b.xmi|2|b.xmi",
        "validate . --ocl a.ocl|2|. is a folder",
        "validate a.xmi .|2|files are named one by one",
        "generate --template t.mtl m.xmi|2|-o",
        "explain nothing.at.all|2|explain.unknown",
      })
  void wrongUsageSaysWhatIsWrong(String command, int code, String text) {
    ended = new Program().run((Object[]) command.split(" ", -1));
    ended.expect(code).says(text);
  }

  /** Returns all files below a folder, except the records of stages. */
  private static Set<Path> filesIn(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> !file.toString().contains("/.stages/"))
          .collect(Collectors.toCollection(TreeSet::new));
    }
  }

  private void replaceDecision(String body) throws IOException {
    Files.writeString(
        project.resolve(DECISION),
        "class Braking_Decision:\n    def execute(self, ttc):\n        " + body + "\n");
  }
}

package dev.eventchain.endtoend;

import static dev.eventchain.endtoend.WarningProject.COMPONENT;
import static dev.eventchain.endtoend.WarningProject.NAME;
import static dev.eventchain.endtoend.WarningProject.SIGN;
import static dev.eventchain.endtoend.WarningProject.TESTS;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests of {@code mutate}. */
class MutateTest {

  private static final String SURVIVED = "mutation.survived";

  private static final String ENTRY =
      "- {component: Collision_Warning, mutant: '%s', reason: a measurement, expires: %s}\n";

  private static final String LIMITS =
      """
      WARNING = 2.6

      def is_near(seconds):
          return seconds < WARNING

      def never_called(seconds):
          return seconds < 7.5
      """;

  @TempDir Path folder;
  private WarningProject project;
  private ProjectCopy copy;

  @BeforeEach
  void copyTheExample() throws IOException {
    project = WarningProject.below(folder);
    copy = project.copy();
  }

  @Test
  void survivorsAreFindingsWithTheirLineAndWhatToAdd() throws IOException {
    Program.Ended ended = project.mutate().expect(1);
    ended.says("Collision_Warning.py:3:15: error: ").says("[" + SURVIVED + "]");
    ended.says("constant in module, WARNING_TTC = 2.6 -> WARNING_TTC = 2.34.");
    ended.says("in none of which it changes an output: comparison in execute, ");
    ended.says("add a test to tests/Collision_Warning.yaml").says("accept it in mutants.yaml");
    ended.says("component                     mutants  by test   by run accepted  survive");
    ended.says("Collision_Warning                   7        0        1        0        6");
    assertTrue(project.outcomes().contains("CRITERION"), project.outcomes()::toString);
    String first = Files.readString(copy.path().resolve("out/mutants.json"));
    project.mutate().expect(1).says("= Simulate").says("unchanged: 7 mutants").says(SURVIVED);
    assertEquals(first, Files.readString(copy.path().resolve("out/mutants.json")));
  }

  @Test
  void testsOfTheComponentCatchThem() throws IOException {
    copy.write("tests/" + NAME + ".yaml", TESTS);
    project.mutate("--format", "json").expect(0).says("\"findings\" : [ ]");
    assertEquals(Set.of("TEST"), project.outcomes());
    assertTrue(project.results().size() > 40, "the others are listed, too");
    assertEquals("NOT_TRIED", project.results().get(0).path("outcome").asText());
  }

  /** All examples are tried in the profile {@code thorough}, the smallest one in each build. */
  @InTurn
  @ParameterizedTest
  @MethodSource("examples")
  void noDefectOfAnExampleStaysUnexplained(String example) throws IOException {
    Path own = folder.resolve("own").resolve(example);
    Projects.copy(Program.ROOT.resolve("examples").resolve(example), own);
    new Program().run("mutate", Projects.withoutStrength(own)).expect(0);
  }

  static Stream<String> examples() {
    return Thorough.allOrFirst(List.of("radar-aeb", "cut-in", "lane-departure", "acc", "aeb"))
        .stream();
  }

  @InTurn
  @Test
  void acceptedMutantsAreExplainedForATime() throws IOException {
    copy.write("tests/" + NAME + ".yaml", TESTS.replaceFirst("(?m)^.*at the limit.*\n", ""));
    project.mutate().expect(1).says("2.626").says("2.86").says("<=");
    String boundary = "comparison in execute, ''warns'': ttc < WARNING_TTC -> ''warns'': ttc <= ";
    String one = ENTRY.formatted(boundary + "WARNING_TTC", "2999-12-31");
    String limit = "constant in module, WARNING_TTC = 2.6 -> WARNING_TTC = ";
    String two = ENTRY.formatted(limit + "2.626", "2999-12-31");
    String three = ENTRY.formatted(limit + "2.86", "2999-12-31");
    copy.write("mutants.yaml", one + two + three);
    project.mutate().expect(0).says("7        4        0        3        0");
    copy.write("mutants.yaml", one + two + three.replace("2999", "2001"));
    project
        .mutate()
        .expect(1)
        .says("2.86. [" + SURVIVED)
        .says("mutants.yaml:3:3: warning: ")
        .says("expired");
    String caught = ENTRY.formatted(limit + "2.34", "2999-12-31");
    copy.write("mutants.yaml", one + two + three + caught + caught.replace("2.34", "2.35"));
    Program.Ended ended = project.mutate().expect(0);
    ended.says("WARNING_TTC = 2.34' of Collision_Warning is caught. [mutation.accepted]");
    ended.says("WARNING_TTC = 2.35' of Collision_Warning does not exist.");
    copy.write("mutants.yaml", one + one.replace("reason: a measurement", "reason: ' '"));
    project.mutate().expect(2).says("accepted twice").says("'reason' is empty");
  }

  @InTurn
  @Test
  void onlyChangedLinesAreMutatedSinceARevision() throws Exception {
    commit();
    project.mutate("--since", "HEAD").expect(0).says("mutation.none").says("since HEAD");
    copy.replace(COMPONENT, "WARNING_TTC = 2.6", "WARNING_TTC = 2.61");
    project.mutate("--since", "HEAD").expect(1).says("Collision_Warning                   4");
    project.mutate("--since", "no-such").expect(2).says("mutation.since");
  }

  /** Its source is checked as that of components is, and its defects are tried like theirs. */
  @Test
  void mutantsAreMadeOfANodeAsItIs() throws Exception {
    copy.delete(COMPONENT);
    copy.write(
        "software-base/nodes/stamps.py", "import time\n\n\ndef now():\n    return time.time()\n");
    copy.write(
        "software-base/nodes/warning.py",
        """
        import time
        import limits
        import stamps
        from demo_msgs.msg import Threat
        from rclpy.node import Node
        from std_msgs.msg import Bool

        class Warning(Node):
            def __init__(self):
                super().__init__("warning")
                self.output = self.create_publisher(Bool, "/cluster/collision_warning", 10)
                self.create_subscription(Threat, "/aeb/threat", self.on_threat, 10)

            def on_threat(self, threat):
                time.sleep(0.001)
                self.output.publish(Bool(data=limits.is_near(threat.time_to_collision)))
        """);
    copy.write("software-base/nodes/limits.py", LIMITS);
    project.hostTheNode();
    new Program()
        .run("validate", copy.path())
        .expect(1)
        .says("software-base/nodes/warning.py:15:14: error: 'time.sleep'")
        .says("software-base/nodes/stamps.py:5:17: warning: 'time.time'")
        .says("self.get_clock()");
    copy.replace("software-base/nodes/warning.py", "time.sleep(0.001)", "pass");
    Program.Ended ended = project.mutate().expect(1);
    ended.says("software-base/nodes/limits.py:4:12: error: No scenario would tell this defect");
    ended.says("No test and no scenario notices this defect: constant in module");
    ended.says("add a scenario, in which this line decides. If it is right, too");
    ended.says("software-base/nodes/stamps.py: warning: No mutants were made of this module");
    ended.says("[mutation.left-out]");
    ended.says("Collision_Warning                    3        0        3        0        0");
    ended.says("software-base/nodes/limits.py        6        0        1        0        5");
    assertEquals(
        Set.of("CRITERION", "UNNOTICED", "UNCHANGED"),
        project.outcomes("software-base/nodes/limits.py"));
  }

  /** A module has each mutant once, whoever imports it, and is tried in all of them. */
  @InTurn
  @Test
  void mutantsAreMadeOfModulesThatComponentsImport() throws IOException {
    copy.write("software-base/components/limits.py", LIMITS);
    copy.write(
        COMPONENT,
        """
        import limits

        class Collision_Warning:
            def execute(self, ttc):
                return {"warns": limits.is_near(ttc)}
        """);
    copy.write("tests/" + NAME + ".yaml", TESTS.replaceFirst("(?m)^.*just below.*\n", ""));
    Program.Ended ended = project.mutate();
    ended.says("limits.py:1:11: error: No test and no scenario notices this defect");
    ended.says("add a test to tests/Collision_Warning.yaml");
    Set<String> outcomes = project.outcomes("software-base/components/limits.py");
    assertTrue(outcomes.containsAll(Set.of("TEST", "UNNOTICED")), outcomes::toString);
    assertFalse(outcomes.contains("NOT_TRIED"), outcomes::toString);
    assertFalse(project.results().toString().contains("never_called"), "nobody names it");
    copy.delete("tests/" + NAME + ".yaml");
    project.mutate();
    outcomes = project.outcomes("software-base/components/limits.py");
    assertTrue(outcomes.containsAll(Set.of("CRITERION", "UNNOTICED")), outcomes::toString);
  }

  private void commit() throws IOException, InterruptedException {
    git("init", "--quiet");
    git("add", "--all");
    git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "--quiet", "--message", "all");
  }

  private void git(String... arguments) throws IOException, InterruptedException {
    String[] command = new String[arguments.length + 1];
    command[0] = "git";
    System.arraycopy(arguments, 0, command, 1, arguments.length);
    Process process =
        new ProcessBuilder(command).directory(copy.path().toFile()).inheritIO().start();
    assertEquals(0, process.waitFor());
  }

  @InTurn
  @Test
  void aMutantThatLoopsIsCaughtByItsLimit() throws Exception {
    copy.write(
        COMPONENT,
        """
        class Collision_Warning:
            def execute(self, ttc):
                for _ in range(-1):
                    pass
                return {"warns": ttc < 2.6}
        """);
    copy.write("tests/" + NAME + ".yaml", TESTS);
    commit();
    copy.replace(COMPONENT, "range(-1)", "range(-1000000000000)");
    project.mutate("--since", "HEAD").says("by test");
    JsonNode loops = null;
    for (JsonNode mutant : project.results()) {
      loops = mutant.path("mutant").asText().equals(SIGN) ? mutant : loops;
    }
    assertEquals("TEST", loops.path("outcome").asText());
    assertTrue(loops.path("words").asText().contains("processor time"), loops::toString);
  }

  @Test
  void nothingIsTriedWhereTheProjectDoesNotPass() throws IOException {
    copy.replace(COMPONENT, "WARNING_TTC = 2.6", "WARNING_TTC = 1.6");
    project.mutate().expect(1).says("mutation.unproved").says("FAILED");
    assertFalse(Files.exists(copy.path().resolve("out/mutants.json")));
  }

  /** A component that differs where it is loaded from would let every mutant count as caught. */
  @InTurn
  @Test
  void whatFailsWithoutADefectProvesNothing() throws IOException {
    copy.replace(
        COMPONENT, "return {\"warns\": ttc <", "return {\"warns\": \"out\" in __file__ and ttc <");
    project.mutate().expect(1).says("mutation.unproved").says("fails when it is repeated");
  }

  @Test
  void aComponentThatDecidesNothingHasNoMutants() throws IOException {
    new Program()
        .run("mutate", copy.path(), "--component", "Colision_Warning")
        .expect(2)
        .says("mutation.none")
        .says("Collision_Warning");
  }
}

package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests of {@code mutate}: on one component of a small project, which has seven mutants. */
class MutateTest {

  private static final String NAME = "Collision_Warning";
  private static final String COMPONENT = "software-base/components/" + NAME + ".py";
  private static final String SURVIVED = "mutation.survived";

  /** Tests that notice each mutant: at the limit, below it, and after a warning. */
  private static final String TESTS =
      """
      tests:
        - {name: at the limit, requirement: RAD-2, inputs: {ttc: 2.6}, outputs: {warns: false}}
        - {name: just below, requirement: RAD-2, inputs: {ttc: 2.59}, outputs: {warns: true}}
        - {name: afterwards, requirement: RAD-2, steps: [{inputs: {ttc: 1}}, {inputs: {ttc: 3}}],
           outputs: {warns: false}}
      """;

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

  private static final String SIGN = "sign in execute, -1000000000000 -> 1000000000000";

  @TempDir Path folder;
  private ProjectCopy copy;

  @BeforeEach
  void copyTheExample() throws IOException {
    copy = ProjectCopy.of("radar-aeb", folder);
    copy.onlyScenario("scenarios/stopped-vehicle-50.yaml");
    copy.endAtEightSeconds();
  }

  private Program.Ended mutate(Object... more) {
    Object[] arguments = new Object[more.length + 4];
    arguments[0] = "mutate";
    arguments[1] = copy.path();
    arguments[2] = "--component";
    arguments[3] = NAME;
    System.arraycopy(more, 0, arguments, 4, more.length);
    return new Program().run(arguments);
  }

  private JsonNode results() throws IOException {
    return new ObjectMapper()
        .readTree(copy.path().resolve("out/mutants.json").toFile())
        .path("mutants");
  }

  private Set<String> outcomes() throws IOException {
    return outcomes(NAME);
  }

  private Set<String> outcomes(String component) throws IOException {
    Set<String> outcomes = new TreeSet<>();
    for (JsonNode mutant : results()) {
      if (mutant.path("component").asText().equals(component)) {
        outcomes.add(mutant.path("outcome").asText());
      }
    }
    return outcomes;
  }

  @Test
  void survivorsAreFindingsWithTheirLineAndWhatToAdd() throws IOException {
    Program.Ended ended = mutate().expect(1);
    ended.says("Collision_Warning.py:3:15: error: ").says("[" + SURVIVED + "]");
    ended.says("constant in module, WARNING_TTC = 2.6 -> WARNING_TTC = 2.34.");
    ended.says("in none of which it changes an output: comparison in execute, ");
    ended.says("add a test to tests/Collision_Warning.yaml").says("accept it in mutants.yaml");
    ended.says("component                     mutants  by test   by run accepted  survive");
    ended.says("Collision_Warning                   7        0        1        0        6");
    assertTrue(outcomes().contains("CRITERION"), outcomes()::toString);
    String first = Files.readString(copy.path().resolve("out/mutants.json"));
    mutate().expect(1).says("= Simulate").says("unchanged: 7 mutants").says(SURVIVED);
    assertEquals(first, Files.readString(copy.path().resolve("out/mutants.json")));
  }

  @Test
  void testsOfTheComponentCatchThem() throws IOException {
    copy.write("tests/" + NAME + ".yaml", TESTS);
    mutate("--format", "json").expect(0).says("\"findings\" : [ ]");
    assertEquals(Set.of("TEST"), outcomes());
    assertTrue(results().size() > 40, "the others are listed, too");
    assertEquals("NOT_TRIED", results().get(0).path("outcome").asText());
  }

  /** All examples are tried in the profile {@code thorough}, the smallest one in each build. */
  @InTurn
  @ParameterizedTest
  @MethodSource("examples")
  void noDefectOfAnExampleStaysUnexplained(String example) throws IOException {
    Path project = folder.resolve("own").resolve(example);
    Projects.copy(Program.ROOT.resolve("examples").resolve(example), project);
    new Program().run("mutate", Projects.withoutStrength(project)).expect(0);
  }

  static Stream<String> examples() {
    return Thorough.allOrFirst(List.of("radar-aeb", "cut-in", "lane-departure", "acc", "aeb"))
        .stream();
  }

  @InTurn
  @Test
  void acceptedMutantsAreExplainedForATime() throws IOException {
    copy.write("tests/" + NAME + ".yaml", TESTS.replaceFirst("(?m)^.*at the limit.*\n", ""));
    mutate().expect(1).says("2.626").says("2.86").says("<=");
    String boundary = "comparison in execute, ''warns'': ttc < WARNING_TTC -> ''warns'': ttc <= ";
    String one = ENTRY.formatted(boundary + "WARNING_TTC", "2999-12-31");
    String limit = "constant in module, WARNING_TTC = 2.6 -> WARNING_TTC = ";
    String two = ENTRY.formatted(limit + "2.626", "2999-12-31");
    String three = ENTRY.formatted(limit + "2.86", "2999-12-31");
    copy.write("mutants.yaml", one + two + three);
    mutate().expect(0).says("7        4        0        3        0");
    copy.write("mutants.yaml", one + two + three.replace("2999", "2001"));
    mutate()
        .expect(1)
        .says("2.86. [" + SURVIVED)
        .says("mutants.yaml:3:3: warning: ")
        .says("expired");
    String caught = ENTRY.formatted(limit + "2.34", "2999-12-31");
    copy.write("mutants.yaml", one + two + three + caught + caught.replace("2.34", "2.35"));
    Program.Ended ended = mutate().expect(0);
    ended.says("WARNING_TTC = 2.34' of Collision_Warning is caught. [mutation.accepted]");
    ended.says("WARNING_TTC = 2.35' of Collision_Warning does not exist.");
    copy.write("mutants.yaml", one + one.replace("reason: a measurement", "reason: ' '"));
    mutate().expect(2).says("accepted twice").says("'reason' is empty");
  }

  @InTurn
  @Test
  void onlyChangedLinesAreMutatedSinceARevision() throws Exception {
    commit();
    mutate("--since", "HEAD").expect(0).says("mutation.none").says("since HEAD");
    copy.replace(COMPONENT, "WARNING_TTC = 2.6", "WARNING_TTC = 2.61");
    mutate("--since", "HEAD").expect(1).says("Collision_Warning                   4");
    mutate("--since", "no-such").expect(2).says("mutation.since");
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
    hostTheNode();
    new Program()
        .run("validate", copy.path())
        .expect(1)
        .says("software-base/nodes/warning.py:15:14: error: 'time.sleep'")
        .says("software-base/nodes/stamps.py:5:17: warning: 'time.time'")
        .says("self.get_clock()");
    copy.replace("software-base/nodes/warning.py", "time.sleep(0.001)", "pass");
    Program.Ended ended = mutate().expect(1);
    ended.says("software-base/nodes/limits.py:4:12: error: No scenario would tell this defect");
    ended.says("No test and no scenario notices this defect: constant in module");
    ended.says("add a scenario, in which this line decides. If it is right, too");
    ended.says("software-base/nodes/stamps.py: warning: No mutants were made of this module");
    ended.says("[mutation.left-out]");
    ended.says("Collision_Warning                    3        0        3        0        0");
    ended.says("software-base/nodes/limits.py        6        0        1        0        5");
    assertEquals(
        Set.of("CRITERION", "UNNOTICED", "UNCHANGED"), outcomes("software-base/nodes/limits.py"));
  }

  /** Hosts the node of the warning as it is, instead of the component. */
  private void hostTheNode() throws IOException {
    copy.replace(
        "software-base/components.json",
        "\"name\": \"" + NAME + "\",",
        "\"name\": \""
            + NAME
            + "\", \"implementation\": \"node\", \"file\": \"nodes/warning.py\","
            + " \"node\": {\"class\": \"Warning\"},");
    copy.replace(
        "model/chain.xmi",
        "name=\"" + NAME + "\"",
        "name=\"" + NAME + "\" implementation=\"NODE\"");
  }

  /** The host of the nodes is gone then, and others have to go on in a new one. */
  @InTurn
  @Test
  void aMutantThatEndsTheProcessOfTheNodesIsCaught() throws IOException {
    copy.delete(COMPONENT);
    copy.write(
        "software-base/nodes/warning.py",
        """
        import os
        from demo_msgs.msg import Threat
        from rclpy.node import Node
        from std_msgs.msg import Bool

        class Warning(Node):
            def __init__(self):
                super().__init__("warning")
                self.output = self.create_publisher(Bool, "/cluster/collision_warning", 10)
                self.create_subscription(Threat, "/aeb/threat", self.on_threat, 10)

            def on_threat(self, threat):
                if threat.time_to_collision < -1000000000000.0:
                    os._exit(3)
                self.output.publish(Bool(data=threat.time_to_collision < 2.6))
        """);
    hostTheNode();
    mutate().expect(1).says("[" + SURVIVED + "]");
    assertTrue(outcomes().containsAll(Set.of("ENDED", "UNNOTICED")), outcomes()::toString);
    assertFalse(outcomes().contains("UNPROVED"), outcomes()::toString);
    assertFalse(outcomes().contains("NOT_TRIED"), outcomes()::toString);
    for (JsonNode mutant : results()) {
      if (mutant.path("outcome").asText().equals("ENDED")) {
        assertTrue(
            mutant.path("words").asText().endsWith("with the exit code 3."), mutant::toString);
      }
    }
  }

  /** A scenario that the project itself does not survive tells nothing, and the others do. */
  @InTurn
  @Test
  void aProcessThatEndsWithoutADefectLeavesTheOthersToJudge() throws IOException {
    String scenario = Files.readString(copy.path().resolve("scenarios/stopped-vehicle-50.yaml"));
    copy.write(
        "scenarios/ending.yaml",
        scenario
            .replace("name: stopped-vehicle-50", "name: ending")
            .replace("gap_m: 80", "gap_m: 90"));
    copy.write(
        COMPONENT,
        """
        import os

        class Collision_Warning:
            def __init__(self):
                self.first = None

            def execute(self, ttc):
                self.first = self.first or (ttc if ttc < 900.0 else None)
                if "copy-" in __file__ and self.first and self.first > 6.2:
                    os._exit(3)
                return {"warns": ttc < 2.6}
        """);
    Program.Ended ended = mutate().expect(1);
    ended.says(
        "scenarios/ending.yaml:1:1: warning: Without a defect, a process ends, too, so that");
    ended.says("mutants: in the scenario ending, 3 of 3 times: ");
    ended.says("error: Nothing is known about this defect, since a process ended, and not each");
    assertTrue(outcomes().contains("CRITERION"), ended::out);
    assertTrue(outcomes().contains("UNPROVED"), outcomes()::toString);
    assertFalse(outcomes().contains("UNNOTICED"), outcomes()::toString);
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
    Program.Ended ended = mutate();
    ended.says("limits.py:1:11: error: No test and no scenario notices this defect");
    ended.says("add a test to tests/Collision_Warning.yaml");
    Set<String> outcomes = outcomes("software-base/components/limits.py");
    assertTrue(outcomes.containsAll(Set.of("TEST", "UNNOTICED")), outcomes::toString);
    assertFalse(outcomes.contains("NOT_TRIED"), outcomes::toString);
    assertFalse(results().toString().contains("never_called"), "nobody names it");
    copy.delete("tests/" + NAME + ".yaml");
    mutate();
    outcomes = outcomes("software-base/components/limits.py");
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
    mutate("--since", "HEAD").says("by test");
    JsonNode loops = null;
    for (JsonNode mutant : results()) {
      loops = mutant.path("mutant").asText().equals(SIGN) ? mutant : loops;
    }
    assertEquals("TEST", loops.path("outcome").asText());
    assertTrue(loops.path("words").asText().contains("processor time"), loops::toString);
  }

  @InTurn
  @Test
  void aMutantThatEndsItsOwnProcessIsCaughtByItsTest() throws Exception {
    copy.write(
        COMPONENT,
        """
        import os

        class Collision_Warning:
            def execute(self, ttc):
                if ttc < -1000000000000:
                    os._exit(3)
                return {"warns": ttc < 2.6}
        """);
    copy.write("tests/" + NAME + ".yaml", TESTS);
    mutate().says("by test");
    assertFalse(outcomes().contains("UNPROVED"), outcomes()::toString);
    for (JsonNode mutant : results()) {
      if (mutant.path("mutant").asText().equals(SIGN)) {
        assertEquals("TEST", mutant.path("outcome").asText());
        assertTrue(
            mutant.path("words").asText().contains("ended with the exit code 3"), mutant::toString);
      }
    }
  }

  @Test
  void nothingIsTriedWhereTheProjectDoesNotPass() throws IOException {
    copy.replace(COMPONENT, "WARNING_TTC = 2.6", "WARNING_TTC = 1.6");
    mutate().expect(1).says("mutation.unproved").says("FAILED");
    assertFalse(Files.exists(copy.path().resolve("out/mutants.json")));
  }

  /** A component that differs where it is loaded from would let every mutant count as caught. */
  @InTurn
  @Test
  void whatFailsWithoutADefectProvesNothing() throws IOException {
    copy.replace(
        COMPONENT, "return {\"warns\": ttc <", "return {\"warns\": \"out\" in __file__ and ttc <");
    mutate().expect(1).says("mutation.unproved").says("fails when it is repeated");
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

package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that a failed verdict is sent back to the authors of the components. The answers come by
 * hand-off, with each prompt in a file; all others come from the recordings of the example.
 */
class VerdictCorrectionTest {
  private static final String SAME = "nothing has changed since";
  private static final String DECISION = "Braking_Decision";

  /** Component that passes its only test, and brakes too late. */
  private static final String LATE =
      """
      class Braking_Decision:
          \"""Brakes late.\"""

          def execute(self, ttc):
              \"""Take the TTC in s; return the force.\"""
              return {"braking_force": 1.0 if ttc < 0.3 else 0.0}
      """;

  @TempDir private static Path failed;

  @TempDir private Path folder;
  private Path project;
  private String right;

  @BeforeEach
  void copyExampleWithoutTheDecision() throws IOException {
    project = Program.exampleIn(folder);
    try (Stream<Path> files = Files.list(project.resolve("recordings/implement"))) {
      for (Path file : files.toList()) {
        JsonNode text = new ObjectMapper().readTree(file.toFile()).at("/samples/0/text");
        List<String> lines = new ArrayList<>();
        text.forEach(line -> lines.add(line.asText()));
        String answer = String.join("\n", lines);
        if (answer.contains("class " + DECISION)) {
          right = answer;
          Files.delete(file);
        }
      }
    }
    Files.createDirectories(project.resolve("tests"));
    Files.writeString(
        project.resolve("tests/" + DECISION + ".yaml"),
        """
        tests:
          - {name: a crash, requirement: AEB-4, inputs: {ttc: 0.1}, outputs: {braking_force: 1}}
        """);
  }

  private Program.Ended run() {
    return new Program().run("run", project, "--llm", "handoff:" + folder.resolve("asked"));
  }

  private String prompt(String name) throws IOException {
    return Files.readString(folder.resolve("asked/" + name + ".prompt.md"));
  }

  private void answer(int number, String code) throws IOException {
    answer("implement-0" + number, "python", code);
  }

  private void answer(String name, String kind, String text) throws IOException {
    Files.writeString(
        folder.resolve("asked/" + name + ".answer.md"), "```" + kind + "\n" + text + "\n```\n");
  }

  private void diagnose(int number, String wrong, String name, String why) throws IOException {
    answer(
        "diagnose-0" + number,
        "json",
        "{\"wrong\": \"%s\", \"name\": \"%s\", \"why\": \"%s\"}".formatted(wrong, name, why));
  }

  /** Has the component that brakes too late simulated, once for all tests. */
  private void failOnce() throws IOException {
    if (!Files.exists(failed.resolve("asked"))) {
      run().expect(4);
      answer(1, LATE);
      run().expect(4).says("waiting for 1 answer");
      copy(folder, failed);
    } else {
      copy(failed, folder);
    }
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Path target = to.resolve(from.relativize(file).toString());
        Files.createDirectories(target.getParent());
        Files.copy(file, target, StandardCopyOption.REPLACE_EXISTING);
      }
    }
  }

  private String component(String name) throws IOException {
    return Files.readString(project.resolve("out/components/" + name + ".py"));
  }

  @InTurn
  @Test
  void failedVerdictLeadsToACorrectedComponent() throws IOException {
    run().expect(4);
    answer(1, LATE);
    run()
        .expect(4)
        .says("1 of 2 scenarios passed")
        .says("[simulation.criterion.failed]")
        .says("waiting for 1 answer");
    assertTrue(
        Files.readString(project.resolve("out/verdict.json")).contains("\"passed\" : false"));
    String asked = prompt("diagnose-01");
    assertTrue(asked.contains("expected braking while TTC is below 2.0 s, but found"), asked);
    assertTrue(asked.contains("It judges AEB-4: \"Partial brake if 1.0s"), asked);
    assertTrue(asked.contains(LATE.strip()), "the code");
    assertTrue(asked.contains("name: a crash"), "the tests");
    assertTrue(asked.contains("can be corrected: TTC_Calculation, Braking_Decision"), asked);
    assertTrue(asked.contains("/scan.ranges [m] | /aeb/time_to_collision.data [s] |"), asked);
    assertTrue(asked.contains(" of 181) |"), "arrays are summed up");
    assertTrue(asked.contains("(decides) |"), asked);
    assertTrue(asked.contains("These never change: "), asked);

    diagnose(1, "component", DECISION, "It brakes below 0.3 s only.");
    run().expect(4).says(SAME);
    String told = prompt("implement-02");
    assertTrue(told.contains(LATE), told);
    assertTrue(told.contains("> It brakes below 0.3 s only."), told);
    assertTrue(told.contains("| time [s] | input ttc [s] |"), told);

    answer(2, right.replace("```python\n", "").replace("```", ""));
    run()
        .expect(0)
        .says("Braking_Decision corrected after the verdict")
        .says("PASSED: 2 of 2 scenarios passed");
    assertTrue(component(DECISION).contains("FULL_BRAKE_TTC"));
    run().expect(0).says("= Implement").says("= Simulate");
    assertEquals(3, spoken("Braking_Decision.py"), "the prompt, the verdict and the correction");
  }

  @InTurn
  @Test
  void theNextDiagnosisKnowsWhatDidNotHelp() throws IOException {
    failOnce();
    diagnose(1, "component", "TTC_Calculation", "It is late.");
    run().expect(4);
    answer(2, component("TTC_Calculation")); // finds no fault in it
    run().expect(4).says("waiting for 1 answer");
    assertTrue(prompt("diagnose-02").contains("- component `TTC_Calculation`: It is late."));
  }

  @InTurn
  @Test
  void aLaterRunKnowsWhatDidNotHelpAndAsksTheSame() throws IOException {
    failOnce();
    diagnose(1, "component", DECISION, "It brakes late.");
    run().expect(4);
    answer(2, LATE.replace("0.3", "0.4"));
    run().expect(4).says("corrected after the verdict").says("waiting for 1 answer");
    String asked = prompt("diagnose-02");
    assertTrue(asked.contains("- component `Braking_Decision`: It brakes late."), asked);
    run().expect(4).says("= Implement").says("waiting for 1 answer");
    assertEquals(asked, prompt("diagnose-02"));
    diagnose(2, "component", DECISION, "It still brakes late.");
    run().expect(4);
    assertFalse(Files.exists(folder.resolve("asked/diagnose-03.prompt.md")), "already answered");
    assertTrue(prompt("implement-03").contains("> It still brakes late."));
  }

  @InTurn
  @Test
  void anAnswerThatNamesNothingToCorrectIsSentBack() throws IOException {
    failOnce();
    diagnose(1, "component", "Lidar_To_Scan", "It is late.");
    run().expect(4);
    String again = prompt("diagnose-02");
    assertTrue(again.contains("which cannot be corrected as component"), again);
    assertTrue(again.contains("It is one of TTC_Calculation, Braking_Decision."), again);
  }

  @Test
  void aRequirementThatNobodyCanMeetIsAQuestionToAPerson() throws IOException {
    failOnce();
    diagnose(1, "requirement", "AEB-4", "May the force depend on the speed?");
    run()
        .expect(1)
        .says("No design may be able to do all that is asked for (AEB-4): May the force depend")
        .says("[agents.verdict.question]")
        .says("FAILED: 1 of 2 scenarios passed");
  }

  /** A person who answers needs several commands, of which only the first one has to simulate. */
  @Test
  void whatFailedIsSimulatedAgainOnlyIfSomethingHasChanged() throws IOException {
    failOnce();
    run().expect(4);
    String verdict = Files.readString(project.resolve("out/verdict.json"));
    String asked = prompt("diagnose-01");
    run().expect(4).says(SAME).says("[simulation.criterion.failed]").says("waiting for 1 answer");
    assertEquals(verdict, Files.readString(project.resolve("out/verdict.json")));
    assertEquals(asked, prompt("diagnose-01"));
    Files.writeString(
        project.resolve("bench.yaml"), "# Another text.\n", StandardOpenOption.APPEND);
    assertFalse(run().expect(4).err().contains(SAME), "a file has changed");
    run().expect(4).says(SAME);
    Files.delete(project.resolve("out/measurements.json"));
    assertFalse(run().expect(4).err().contains(SAME), "a result is gone");
    assertTrue(Files.exists(project.resolve("out/measurements.json")));
    Files.writeString(
        project.resolve("eventchain-suppressions.yaml"),
        "- {id: ocl.violated, rule: SPEED, reason: known, expires: 2999-12-31}\n");
    assertFalse(run().expect(4).err().contains(SAME), "results depend on suppressions");
    run().expect(4).says(SAME);
  }

  @InTurn
  @Test
  void testsOfPeopleAreNotChanged() throws IOException {
    failOnce();
    diagnose(1, "test", DECISION, "It tests one value only.");
    run()
        .expect(1)
        .says("The tests of Braking_Decision, which people wrote, may be wrong: It tests one")
        .says("[agents.verdict.question]");
  }

  @InTurn
  @Test
  void testsOfALanguageModelAreCorrectedAndThenTheCode() throws IOException {
    failOnce();
    diagnose(1, "test", "TTC_Calculation", "They demand too much.");
    run().expect(4);
    String told = prompt("test-01");
    assertTrue(told.contains("> They demand too much."), told);
    String tests = Files.readString(project.resolve("out/tests/TTC_Calculation.yaml"));
    answer("test-01", "json", lessThan(told));
    run().expect(4);
    assertTrue(prompt("implement-02").contains("> They demand too much."));
    answer(2, component("TTC_Calculation") + "\n# the same\n");
    run().expect(4).says("waiting for 1 answer"); // It still fails: another diagnosis is due.
    assertTrue(prompt("diagnose-02").contains("- test `TTC_Calculation`: They demand too much."));
    assertNotEquals(tests, Files.readString(project.resolve("out/tests/TTC_Calculation.yaml")));
  }

  /** Returns the tests in a prompt without the last one. */
  private static String lessThan(String prompt) throws IOException {
    int start = prompt.indexOf("```json\n", prompt.indexOf("\"tests\"") - 200);
    String json = prompt.substring(prompt.indexOf('{', start), prompt.indexOf("\n```", start + 8));
    ObjectNode tests = (ObjectNode) new ObjectMapper().readTree(json);
    ArrayNode all = (ArrayNode) tests.get("tests");
    all.remove(all.size() - 1);
    return tests.toString();
  }

  /** Each step is a run of its own: nothing that was corrected before is lost on the way. */
  @InTurn
  @Test
  void anotherDesignIsAskedForAndOnlyWhatDependsOnItIsWrittenAgain() throws IOException {
    failOnce();
    diagnose(1, "component", "TTC_Calculation", "It is late.");
    run().expect(4);
    answer(2, component("TTC_Calculation") + "\n# corrected\n");
    run().expect(4);
    diagnose(2, "design", DECISION, "It does not say from which time to collision on to brake.");
    run().expect(4);
    String told = prompt("design-01");
    assertTrue(told.contains("> It does not say from which time to collision on to brake."), told);
    String present = Files.readString(project.resolve("out/chain.json"));
    String other =
        present.replace("\"description\": \"Determines", "\"description\": \"It determines");
    assertNotEquals(present, other);
    answer("design-01", "json", other);
    String corrected = component("TTC_Calculation");
    assertTrue(corrected.endsWith("# corrected\n"), corrected);
    run().expect(4);
    assertTrue(prompt("implement-03").contains("It determines"), "its author gets the new text");
    assertFalse(Files.exists(folder.resolve("asked/implement-04.prompt.md")), "only this one");
    answer(3, right.replace("```python\n", "").replace("```", ""));
    run().expect(4).says("waiting for"); // The model of another chain is asked for, too.
    assertTrue(Files.exists(folder.resolve("asked/model-01.prompt.md")));
    assertEquals(corrected, component("TTC_Calculation"));
  }

  /** A criterion that the design gives nothing to read is a question about the design. */
  @InTurn
  @Test
  void anOutputThatTheDesignLacksIsAskedOfItsAuthor() throws IOException {
    run().expect(4);
    answer(1, right.replace("```python\n", "").replace("```", ""));
    Path scenario = project.resolve("scenarios/stopped-vehicle-50.yaml");
    Files.writeString(
        scenario,
        Files.readString(scenario)
            + """
                - name: the emergency is signalled
                  judges: {AEB-3: "signal an emergency braking condition"}
                  formula: always[0.3, 11] (ttc < 0.8 s implies eventually[0, 0.2] output(AEB-3, bool))
            """
                .indent(0));
    run().expect(4).says("waiting for 1 answer");
    String asked = prompt("diagnose-01");
    assertTrue(asked.contains("no output of type bool of the chain satisfies AEB-3"), asked);
    diagnose(1, "design", DECISION, "Nothing tells others of an emergency.");
    run().expect(4);
    assertTrue(prompt("design-01").contains("> Nothing tells others of an emergency."));
  }

  /** Returns the number of answers that the report shows for a file. */
  private long spoken(String file) throws IOException {
    String report = Files.readString(project.resolve("out/report.html"));
    return Stream.of(report.split("\"file\":\"components/" + file, -1)).count();
  }

  /** With recordings only, nothing is corrected, and the verdict names the failures. */
  @InTurn
  @Test
  void verdictStandsWhereNobodyAnswers() throws IOException {
    run().expect(4);
    answer(1, LATE);
    new Program()
        .run(
            "run",
            project,
            "--llm",
            "handoff:" + folder.resolve("asked"),
            "--record",
            "--to",
            "generate")
        .expect(0);
    new Program()
        .run("run", project)
        .expect(1)
        .says("FAILED: 1 of 2 scenarios passed")
        .says("[simulation.criterion.failed]");
    assertFalse(Files.exists(folder.resolve("asked/diagnose-01.prompt.md")));
  }
}

package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
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

  private String prompt(int number) throws IOException {
    return Files.readString(folder.resolve("asked/implement-0" + number + ".prompt.md"));
  }

  private void answer(int number, String code) throws IOException {
    Files.writeString(
        folder.resolve("asked/implement-0" + number + ".answer.md"),
        "```python\n" + code + "```\n");
  }

  private String component(String name) throws IOException {
    return Files.readString(project.resolve("out/components/" + name + ".py"));
  }

  @Test
  void failedVerdictLeadsToACorrectedComponent() throws IOException {
    run().expect(4);
    answer(1, LATE);
    run()
        .expect(4)
        .says("1 of 3 scenarios passed")
        .says("[simulation.criterion.failed]")
        .says("waiting for 1 answer");
    assertTrue(
        Files.readString(project.resolve("out/verdict.json")).contains("\"passed\" : false"));
    assertTrue(
        prompt(2).contains("class TTC_Calculation"), "the first in the chain is asked first");

    answer(2, component("TTC_Calculation")); // finds no errors in it
    run().expect(4);
    String told = prompt(3);
    assertTrue(told.contains(LATE), told);
    assertTrue(told.contains("expected braking while TTC is below 2.0 s, but found"), told);
    assertTrue(told.contains("| time [s] | input ttc [s] |"), told);

    answer(3, right.replace("```python\n", "").replace("```", ""));
    run()
        .expect(0)
        .says("Braking_Decision corrected after the verdict")
        .says("PASSED: 3 of 3 scenarios passed");
    assertTrue(component(DECISION).contains("FULL_BRAKE_TTC"));
    run().expect(0).says("= Implement").says("= Simulate");
    assertEquals(3, spoken("Braking_Decision.py"), "the prompt, the verdict and the correction");
  }

  /** Returns the number of answers that the report shows for a file. */
  private long spoken(String file) throws IOException {
    String report = Files.readString(project.resolve("out/report.html"));
    return Stream.of(report.split("\"file\":\"components/" + file, -1)).count();
  }

  /** With recordings only, nothing is corrected, and the verdict names the failures. */
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
        .says("FAILED: 1 of 3 scenarios passed")
        .says("[simulation.criterion.failed]");
    assertFalse(Files.exists(folder.resolve("asked/implement-02.prompt.md")));
  }
}

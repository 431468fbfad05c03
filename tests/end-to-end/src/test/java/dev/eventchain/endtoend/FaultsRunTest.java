package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests faults from the command line to exit code, verdict and report. */
class FaultsRunTest {

  private static final String FAULTS =
      """
      faults:
        - name: decision-dies
          scenario: stopped-vehicle-50
          at_s: 2
          kill: Braking_Decision
          expect:
            no_impact: true
        - name: ttc-hangs
          scenario: stopped-vehicle-50
          at_s: 2
          for_s: 1
          stop: TTC_Calculation
          expect:
            detected: true
        - name: slow-detection
          scenario: stopped-vehicle-50
          at_s: 1
          delay: {node: ObjectDetection, ms: 5}
      """;

  @TempDir private Path folder;

  @Test
  void whatIsExpectedDecidesAndTheRestIsObserved() throws IOException {
    ProjectCopy project = ProjectCopy.of("aeb", folder);
    project.onlyScenario("scenarios/stopped-vehicle-50.yaml");
    project.write("faults.yaml", FAULTS);
    Path faults = project.path().resolve("faults.yaml");
    new Program()
        .run("run", project.path(), "--faults", faults)
        .expect(1)
        .says("faults.yaml:7:7: error: Scenario stopped-vehicle-50 with fault 'decision-dies'")
        .says("[simulation.fault.failed]")
        .says("FAILED  decision-dies")
        .says("passed  ttc-hangs")
        .says("-       slow-detection")
        .says("1 of 2 faults as expected, 1 fault not judged");
    JsonNode verdict =
        new ObjectMapper().readTree(project.path().resolve("out/verdict.json").toFile());
    assertFalse(verdict.path("passed").asBoolean());
    assertEquals(3, verdict.path("faults").size());
    assertTrue(verdict.at("/scenarios/0/passed").asBoolean());
    assertTrue(verdict.at("/faults/1/detected").asBoolean());
    String report = Files.readString(project.path().resolve("out/report.html"));
    assertTrue(report.contains("\"faults\":[{\"name\":\"decision-dies\""), "no faults");
    new Program().run("simulate", project.path(), "--faults", folder.resolve("none")).expect(2);
  }
}

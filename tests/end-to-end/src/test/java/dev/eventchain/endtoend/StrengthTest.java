package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the strength of requirements on the radar example: what notices nothing is not tested, and
 * its sharp twin is proved with numbers.
 */
class StrengthTest {

  private static final String SCENARIO = "scenarios/stopped-vehicle-50.yaml";
  private static final String WARNED =
      "{RAD-2: \"warn the driver while the time to collision is below 2.6 s\"}";
  private static final String FOUND = "{RAD-1: \"determine the time to collision\"}";

  /** A drive in which nothing happens, about the requirement on warnings. */
  private static final String CREEPING =
      """
      name: creeping
      title: Behind a slow vehicle
      requirements: [RAD-2]
      seed: 5
      duration_s: 2
      ego: {speed_kmh: 4, coasting_deceleration_mps2: 0}
      actors: [{gap_m: 50, speed_kmh: 4}]
      accept:
        never_brakes: true
      """;

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void copyProject() throws IOException {
    project = ProjectCopy.of("radar-aeb", folder);
    project.onlyScenario(SCENARIO);
    project.endAtEightSeconds();
  }

  private Program.Ended run(Object... more) {
    return new Program()
        .run(Stream.concat(Stream.of("run", project.path()), Stream.of(more)).toArray());
  }

  private JsonNode verdict() throws IOException {
    return new ObjectMapper().readTree(project.path().resolve("out/verdict.json").toFile());
  }

  private JsonNode requirement(String id) throws IOException {
    for (JsonNode each : verdict().path("requirements")) {
      if (each.path("id").asText().equals(id)) {
        return each;
      }
    }
    throw new AssertionError("no requirement " + id);
  }

  /** A criterion that cannot notice what the warning does, beside others that can. */
  @InTurn
  @Test
  void requirementWhoseOnlyCriterionNoticesNothing() throws IOException {
    project.replace(SCENARIO, WARNED, FOUND);
    project.write("scenarios/creeping.yaml", CREEPING);
    run("--strength")
        .expect(1)
        .says("INCOMPLETE: 2 of 2 scenarios passed, but not all was tested")
        .says("The criteria of RAD-2 notice none of")
        .says("[simulation.strength.none RAD-2]")
        .says("not tested  RAD-2: notices 0 of ");
    assertEquals("not tested", requirement("RAD-2").path("outcome").asText());
    assertEquals("proved", requirement("RAD-3").path("outcome").asText());
  }

  @Test
  void itsSharpTwinIsProvedWithNumbers() throws IOException {
    project.replace(SCENARIO, WARNED, FOUND);
    project.write(
        "scenarios/creeping.yaml",
        CREEPING.replace(
            "  never_brakes: true\n",
            """
              never_brakes: true
              formulas:
                - formula: always[0.2, 1.9] not /cluster/collision_warning.data
            """));
    Path cases = folder.resolve("TEST-run.xml");
    run("--strength", "--report", "junit=" + cases)
        .expect(0)
        .says("PASSED: 2 of 2 scenarios passed, 4 requirements proved")
        .says("proved      RAD-2: notices ");
    JsonNode strength = requirement("RAD-2").path("strength");
    assertTrue(strength.path("noticed").asInt() >= 2, strength.toString());
    assertTrue(Files.readString(project.path().resolve("out/report.html")).contains("\"noticed\""));
    assertTrue(Files.readString(cases).contains("proved, notices "), Files.readString(cases));
  }

  /** One scenario that names all requirements, in which the software has nothing to do. */
  @Test
  void prohibitionsAloneProveNothing() throws IOException {
    project.write(SCENARIO, CREEPING.replace("[RAD-2]", "[RAD-1, RAD-2, RAD-3, RAD-4]"));
    run("--strength")
        .expect(1)
        .says("INCOMPLETE: 0 of 1 scenarios passed, but not all was tested")
        .says("it holds for software that does nothing");
    for (String id : new String[] {"RAD-1", "RAD-2", "RAD-3", "RAD-4"}) {
      assertEquals("not tested", requirement(id).path("outcome").asText(), id);
    }
  }

  /**
   * A budget too small for anything: only what would fail because of it is driven as a whole, and a
   * bound is compared with six faults that count for it.
   */
  @InTurn
  @Test
  void strengthBelowWhatTheProjectAsksFor() throws IOException {
    Projects.measureStrength(project.path());
    Path settings = project.path().resolve("eventchain.yaml");
    Files.writeString(
        settings,
        "\nstrength: {minimum_percent: 10, budget_s: 1, requirements: {RAD-2: 95}}\n",
        StandardOpenOption.APPEND);
    run()
        .expect(1)
        .says("INCOMPLETE: 1 of 1 scenarios passed")
        .says("[simulation.strength.low RAD-2]");
    assertFalse(requirement("RAD-2").path("strength").has("sampleOf"));
    JsonNode sample = requirement("RAD-1").path("strength");
    assertTrue(sample.has("sampleOf"), sample.toString());
    assertEquals(6, sample.at("/bound/faults").asInt(), sample.toString());
    assertEquals(sample.path("sampleOf"), sample.at("/bound/sampleOf"), sample.toString());
    assertTrue(verdict().path("strength").asText().startsWith("a sample of "));
    Path other = folder.resolve("elsewhere");
    run("-o", other).expect(1);
    assertEquals(
        Files.readString(project.path().resolve("out/verdict.json")),
        Files.readString(other.resolve("verdict.json")));
    run("--no-strength").expect(0);
    run("--no-strength", "--strength=whole").expect(2).says("--no-strength contradicts");
  }

  @InTurn
  @Test
  void withoutAMeasurementTheVerdictSaysSo() throws IOException {
    run().expect(0).says("strength not measured");
    assertEquals("not measured: the project does not want it", verdict().path("strength").asText());
    assertFalse(requirement("RAD-1").has("strength"));
    Projects.measureStrength(project.path());
    run("--no-strength").expect(0).says("strength not measured");
    assertEquals("not measured: switched off", verdict().path("strength").asText());
  }
}

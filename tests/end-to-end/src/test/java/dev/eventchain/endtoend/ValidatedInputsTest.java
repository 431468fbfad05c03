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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests that {@code validate DIR} reports what {@code run DIR} refuses before it simulates: with
 * exit code 0, everything was checked.
 */
class ValidatedInputsTest {

  /** A fault of the example, which a run injects only with {@code --faults}. */
  private static final String FAULT =
      """
      faults:
        - name: radar-fails
          scenario: stopped-vehicle-50
          at_s: 2
          kill: Brake_Request
      """;

  @TempDir Path folder;

  @ParameterizedTest(name = "{index}: {0} {2}")
  @CsvSource(
      delimiter = '|',
      value = {
        "bench.yaml|drives: acceleration|drives: brakk|bench.actuator.unknown|bench.yaml:15",
        "bench.yaml|/radar/target:|/radar/targett:|bench.topic.unknown|bench.yaml:5",
        "bench.yaml|unit: m,|unit: parsec,|bench.unit|bench.yaml:3",
        "bench.yaml|rate_hz: 50|rate_hz: 0|bench.value.range|bench.yaml:6",
        "bench.yaml|range: min(gap, radar.reach)|# nothing|bench.field.unset|",
        "bench.yaml|rate_hz: 50|'rate_hz: 50\n    latency_ms: 9\n    latency_counts_in: [radar_to_lamp]'|bench.latency.unknown|bench.yaml:5",
        "bench.yaml|consumes:|consumes: [|bench.syntax|bench.yaml:",
        "scenarios/short-sight.yaml|duration_s: 14|duration_s: -8|scenario.value.range|short-sight.yaml:4",
        "scenarios/short-sight.yaml|seed: 4|seeed: 4|scenario.key.unknown|short-sight.yaml:3",
        "scenarios/short-sight.yaml|RAD-1:|RAD-9:|project.requirement.unknown|short-sight.yaml:18",
        "scenarios/short-sight.yaml|eventually[5, 12]|eventualy[5, 12]|scenario.formula|short-sight.yaml:19",
        "scenarios/short-sight.yaml|12 km/h|12 m|scenario.formula.unit|short-sight.yaml:19",
        "scenarios/short-sight.yaml|radar.reach: 60|radar.rech: 60|scenario.input.unknown|short-sight.yaml:11",
        "scenarios/short-sight.yaml|name: short-sight|name: stopped-vehicle-50|scenario.name.duplicate|",
      })
  void whatARunRefusesIsAnErrorOfTheValidation(
      String file, String text, String by, String id, String place) throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.replace(file, text, by);
    Program.Ended validated = new Program().run("validate", copy.path(), "--format", "json");
    List<String> found = errors(validated);
    assertEquals(1, found.stream().filter(each -> each.startsWith(id)).count(), found.toString());
    assertFalse(validated.code() == 0, validated.out());
    assertTrue(place == null || found.toString().contains(place), found.toString());
    List<String> refused = errors(new Program().run("run", copy.path(), "--format", "json"));
    assertEquals(refused, found, "the same findings at the same places");
    copy.requireNotPassed();
  }

  @Test
  void aLatencyThatCountsInConstraintsOfOneNameIsAmbiguous() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    String counted = "rate_hz: 50\n    latency_ms: 9\n    latency_counts_in: [radar_to_brake]";
    copy.replace("bench.yaml", "rate_hz: 50", counted);
    new Program().run("validate", copy.path()).expect(0);
    String end = "</eventchain:EventChain>";
    copy.replace(
        "model/chain.xmi",
        end,
        "<latencyConstraints name=\"radar_to_brake\" first=\"//@software.0\""
            + " last=\"//@software.2\" maximum=\"100.0\"/>"
            + end);
    new Program()
        .run("validate", copy.path())
        .expect(1)
        .says("bench.latency.unknown")
        .says("several latency constraints have that name");
  }

  @Test
  void withoutRequirementsNothingIsProvedAndNothingValid() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    Files.delete(copy.path().resolve("requirements.md"));
    new Program().run("validate", copy.path()).expect(1).says("file.missing").says("RAD-3");
    new Program().run("run", copy.path()).expect(1).says("file.missing").says("RAD-3");
    copy.requireNotPassed();
  }

  @Test
  void aProjectThatNamesNoRequirementNeedsNone() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    Files.delete(copy.path().resolve("requirements.md"));
    for (String scenario : List.of("short-sight", "stopped-vehicle-50")) {
      Path file = copy.path().resolve("scenarios/" + scenario + ".yaml");
      Files.writeString(
          file, Files.readString(file).replaceAll("(?m)^.*(judges:|\\{RAD-).*\n", ""));
    }
    Path model = copy.path().resolve("model/chain.xmi");
    Files.writeString(
        model,
        Files.readString(model)
            .replaceAll(" *<requirements [^>]*/>\n", "")
            .replaceAll(" satisfies=\"[^\"]*\"", ""));
    new Program().run("validate", copy.path()).expect(0);
  }

  @Test
  void aConstraintThatHoldsForAnythingProvesNoRequirement() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    String rule = "-- RAD-2: The driver is warned in time.\ncontext SoftwareNode inv Fast: ";
    copy.write("constraints.ocl", rule + "true\n");
    new Program().run("validate", copy.path()).expect(1).says("ocl:2:").says("cannot prove RAD-2");
    new Program().run("run", copy.path()).expect(1).says("ocl.vacuous");
    copy.requireNotPassed();
    copy.write("constraints.ocl", rule + "self.frequency >= 10\n");
    new Program().run("validate", copy.path()).expect(0);
  }

  @Test
  void aModelIsCheckedWithTheMessagesOfItsProject() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    Path model = copy.path().resolve("model/chain.xmi");
    new Program().run("validate", model).expect(0);
    Path elsewhere = Files.copy(model, folder.resolve("chain.xmi"));
    new Program().run("validate", elsewhere).expect(1).says("contract.message.unknown");
    new Program()
        .run("validate", copy.path(), elsewhere)
        .expect(1)
        .says("contract.message.unknown")
        .says(" in 2 files");
  }

  @Test
  void everyExampleIsSound() throws IOException {
    for (String example : List.of("radar-aeb", "aeb")) {
      ProjectCopy copy = ProjectCopy.of(example, folder);
      new Program().run("validate", copy.path()).expect(0).says("0 errors");
    }
  }

  @Test
  void faultsAreReadFromTheProjectAndFromTheOption() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.write("faults.yaml", FAULT);
    new Program().run("validate", copy.path()).expect(0);
    copy.write("faults.yaml", FAULT.replace("Brake_Request", "Brake_Reqest"));
    new Program()
        .run("validate", copy.path())
        .expect(1)
        .says("faults.yaml:5")
        .says("fault.unknown");
    copy.write("faults.yaml", FAULT);
    copy.write("more.yaml", FAULT.replace("at_s: 2", "at_s: -2"));
    new Program()
        .run("validate", copy.path(), "--faults", copy.path().resolve("more.yaml"))
        .expect(1)
        .says("more.yaml:4")
        .says("fault.value.range");
  }

  @Test
  void severalErrorsAreReportedTogetherAndConsequencesNotAtAll() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.replace("scenarios/short-sight.yaml", "seed: 4", "seeed: 4");
    copy.replace("scenarios/stopped-vehicle-50.yaml", "duration_s: 12", "duration_s: -12");
    copy.replace("model/chain.xmi", "first=\"//@software.0\"", "");
    Program.Ended ended = new Program().run("validate", copy.path(), "--format", "json");
    List<String> found = errors(ended);
    assertEquals(3, found.size(), ended.out());
    ended.says("scenario.key.unknown").says("scenario.value.range").says("ocl.violated");
  }

  @Test
  void anInputThatNeedsARefusedOneIsNoErrorOfItsOwn() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.replace(
        "bench.yaml",
        "radar.reach: {unit: m, value: 150}",
        """
        radar.reach: {formula: 0.5 * driver.wanted}
          driver.pressed: {formula: ego.position > 100 m}
          driver.wanted: {unit: m, formula: "driver.pressed * 1 m"}""");
    Program.Ended ended = new Program().run("validate", copy.path(), "--format", "json");
    assertEquals(1, errors(ended).size(), errors(ended).toString());
    assertTrue(errors(ended).get(0).contains("bench.yaml:4 "), errors(ended).toString());
  }

  @Test
  void aFormulaWithAnErrorDoesNotMakeItsInputUseless() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.replace("bench.yaml", "inputs:", "inputs:\n  road.grip: {value: 1}");
    copy.replace(
        "scenarios/short-sight.yaml", "radar.reach: 60", "radar.reach: 60\n  road.grip: 1");
    copy.replace(
        "scenarios/short-sight.yaml", "ego.speed <= 12 km/h", "ego.speed <= 12 km/h * road.grp");
    Program.Ended ended = new Program().run("validate", copy.path(), "--format", "json");
    assertEquals(1, errors(ended).size(), errors(ended).toString());
    ended.says("Did you mean `road.grip`?");
  }

  /** Returns id, place and message of each error. */
  private static List<String> errors(Program.Ended ended) throws IOException {
    List<String> errors = new ArrayList<>();
    for (JsonNode finding : new ObjectMapper().readTree(ended.out()).path("findings")) {
      if (finding.path("severity").asText().equals("error")) {
        errors.add(
            finding.path("id").asText()
                + " "
                + finding.path("file").asText()
                + ":"
                + finding.path("line").asText()
                + " "
                + finding.path("message").asText());
      }
    }
    return errors;
  }
}

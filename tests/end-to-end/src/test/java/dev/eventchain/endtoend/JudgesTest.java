package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what a criterion judges: words of requirements, and outputs by their role. */
class JudgesTest {

  private static final String SCENARIO = "scenarios/stopped-vehicle-50.yaml";
  private static final String WARNED =
      "formula: always[0.1, 11.5] (ttc < 2.5 s implies eventually[0, 0.2]"
          + " /cluster/collision_warning.data)";

  @TempDir Path folder;
  private ProjectCopy copy;

  @BeforeEach
  void copy() throws IOException {
    copy = ProjectCopy.of("radar-aeb", folder);
  }

  private JsonNode scenario(String name) throws IOException {
    JsonNode measured =
        new ObjectMapper().readTree(copy.path().resolve("out/measurements.json").toFile());
    for (JsonNode each : measured.path("scenarios")) {
      if (each.path("name").asText().equals(name)) {
        return each;
      }
    }
    throw new AssertionError("no " + name + " in " + measured);
  }

  @Test
  void wordsThatTheRequirementDoesNotHaveAreAnError() throws IOException {
    copy.replace(SCENARIO, "RAD-2: \"warn the driver", "RAD-2: \"warn the driver before");
    new Program()
        .run("validate", copy.path())
        .expect(1)
        .says(SCENARIO + ":18:23: error: RAD-2 does not say \"warn the driver before")
        .says("It says: The system shall warn the driver while")
        .says("[scenario.judges.words]");
    new Program().run("run", copy.path()).expect(1).says("scenario.judges.words");
    copy.requireNotPassed();
  }

  @Test
  void aCriterionWithoutWordsIsAWarningWhereOthersHaveSome() throws IOException {
    copy.replace(SCENARIO, "    stops: {RAD-3: \"until the vehicle stands\"}\n", "");
    new Program()
        .run("validate", copy.path())
        .expect(0)
        .says("warning: It does not say which words of a requirement it judges: the vehicle stops")
        .says("[scenario.judges.missing]");
  }

  @Test
  void aNumberThatNoCriterionQuotesIsAWarning() throws IOException {
    copy.replace(SCENARIO, " while the time to collision is below 2.6 s\"}", "\"}");
    new Program()
        .run("validate", copy.path())
        .expect(0)
        .says("requirements.md:3:1: warning: No criterion of a scenario judges '2.6 s' of RAD-2.")
        .says("[scenario.judges.number]");
    copy.replace(SCENARIO, "{RAD-2: \"warn the driver\"}", "{RAD-2: \"below 2.6 s\"}");
    new Program().run("validate", copy.path()).expect(0).says("0 errors, 0 warnings");
  }

  @Test
  void aRequirementThatACriterionDoesNotQuoteIsTestedAsAWhole() throws IOException {
    copy.replace(SCENARIO, " while the time to collision is below 2.6 s\"}", "\"}");
    copy.replace(
        SCENARIO,
        "  formulas:\n",
        "  formulas:\n    - {requirements: [RAD-2], formula: always ego.speed <= 51 km/h}\n");
    new Program()
        .run("validate", copy.path())
        .expect(0)
        .says("[scenario.judges.missing]")
        .says("0 errors, 1 warning ");
  }

  @Test
  void anOutputIsReadByItsRequirementWhateverItsTopic() throws IOException {
    copy.replace(SCENARIO, "/cluster/collision_warning.data", "output(RAD-2, bool)");
    new Program().run("run", copy.path(), "--no-strength").expect(0).says("4 requirements proved");
    JsonNode verdict =
        new ObjectMapper().readTree(copy.path().resolve("out/verdict.json").toFile());
    String judged = verdict.findValuesAsText("requirement") + " " + verdict.findValues("words");
    assertTrue(judged.contains("RAD-2") && judged.contains("\"warn the driver"), judged);
  }

  @InTurn
  @Test
  void anOutputThatNoDesignHasIsNotTested() throws IOException {
    copy.replace(SCENARIO, "/cluster/collision_warning.data", "output(RAD-2, m/s2) > 0 m/s2");
    new Program()
        .run("validate", copy.path())
        .expect(0)
        .says("no output in m/s2 of the chain satisfies RAD-2")
        .says("[scenario.output.unresolved]");
    new Program()
        .run("run", copy.path(), "--no-strength")
        .expect(1)
        .says("was not tested: no output in m/s2 of the chain satisfies RAD-2, only /")
        .says("INCOMPLETE");
  }

  @Test
  void theRestOfAFormulaIsCheckedBeforeThereIsAnOutput() throws IOException {
    copy.replace(SCENARIO, "/cluster/collision_warning.data", "output(RAD-9, m/s2)");
    new Program()
        .run("validate", copy.path())
        .expect(1)
        .says("'output(RAD-9, m/s2)' is a quantity, not true or false.")
        .says("[scenario.formula.syntax]");
  }

  @InTurn
  @Test
  void severalOutputsAreNamed() throws IOException {
    copy.replace(SCENARIO, "/cluster/collision_warning.data", "output(RAD-3) > 0");
    new Program()
        .run("run", copy.path(), "--no-strength")
        .expect(1)
        .says("several outputs of the chain satisfy RAD-3: /brake/request.");
  }

  @Test
  void anOptionalCriterionIsNotAskedWhereItsPremiseDoesNotComeTrue() throws IOException {
    copy.replace(
        SCENARIO,
        WARNED,
        WARNED
            + """

                - name: warned when it is too late
                  judges: {RAD-2: "warn the driver"}
                  optional: true
                  formula: always[0.1, 11.5] (gap < 0.01 m implies /cluster/collision_warning.data)
            """
                .stripTrailing());
    new Program().run("run", copy.path(), "--no-strength").expect(0).says("4 requirements proved");
    JsonNode result = scenario("stopped-vehicle-50");
    assertEquals("warned when it is too late", name(result.path("observed").path(0)));
    assertEquals(7, result.path("criteria").size());
  }

  @Test
  void aRequirementOfWhichNothingWasAskedIsNotTested() throws IOException {
    copy.replace(
        SCENARIO,
        WARNED,
        "optional: true\n      formula: always[0.1, 11.5] (gap < 0.01 m implies"
            + " /cluster/collision_warning.data)");
    new Program()
        .run("run", copy.path(), "--no-strength")
        .expect(1)
        .says("RAD-2")
        .says("[project.requirement.untested RAD-2]")
        .says("3 requirements proved, 1 not tested");
  }

  @Test
  void whatIsObservedIsReportedAndNeverJudged() throws IOException {
    copy.write(
        SCENARIO,
        Files.readString(copy.path().resolve(SCENARIO))
            + "observe:\n  - name: it brakes gently\n    formula: always ego.acceleration >= -2 m/s2\n");
    new Program().run("run", copy.path(), "--no-strength").expect(0).says("4 requirements proved");
    JsonNode observed = scenario("stopped-vehicle-50").path("observed").path(0);
    assertEquals("it brakes gently", name(observed));
    assertTrue(observed.path("tested").booleanValue() && !observed.path("passed").booleanValue());
  }

  private static String name(JsonNode criterion) {
    return criterion.path("text").asText().replaceFirst(" \\(.*", "");
  }
}

package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.CaseReader;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the criteria that a campaign file gives to cases. */
class CriteriaOfCasesTest {

  private static final String SCENARIO =
      """
      {
        "name": "ahead", "title": "A car ahead", "duration_s": 10, "ego": {"speed_kmh": 50},
        "actors": [{"name": "car", "gap_m": 40, "speed_kmh": 0}],
        "accept": {"no_impact": true, "formulas": [{"formula": "always ego.speed <= 20 m/s"}]}
      }
      """;

  @TempDir Path folder;

  private CampaignPlan plan(String criteria) throws IOException {
    String text =
        """
        scenario: ahead
        factors: {speed: {path: ego.speed_kmh, values: [30, 50, 80]}}
        computed: {limit: {path: x, formula: speed - 40}}
        criteria:
        """;
    Path file = Files.writeString(folder.resolve("c.yaml"), text + criteria.indent(2));
    return CampaignReader.read(file).get(0);
  }

  private static CampaignCase of(int speed) {
    return new CampaignCase(List.of(BigDecimal.valueOf(speed)), 1);
  }

  private static ObjectNode scenario() throws IOException {
    return (ObjectNode) new ObjectMapper().readTree(SCENARIO);
  }

  @Test
  void aCaseHasThoseOfAllAndThoseWhoseConditionsItMeets() throws IOException {
    CriteriaOfCases criteria =
        new CriteriaOfCases(
            plan(
                """
                - accept:
                    no_impact: true
                    formulas: [{formula: always ego.speed <= 20 m/s}, {formula: always gap > 1 m}]
                - {where: [limit > 0], accept: {maximal_impact_speed_kmh: 10}}
                - {where: [limit > 0, speed > 60], accept: {minimal_gap_m: 1}}
                """));
    ObjectNode whole = criteria.withThoseOfAll(scenario());
    String all =
        "{\"no_impact\":true,\"formulas\":[{\"formula\":\"always ego.speed <= 20 m/s\"},"
            + "{\"formula\":\"always gap > 1 m\"}]";
    assertEquals(all + "}", criteria.with(whole, of(30)).get("accept").toString());
    assertEquals(
        all + ",\"maximal_impact_speed_kmh\":10}",
        criteria.with(whole, of(50)).get("accept").toString());
    assertEquals(
        all + ",\"maximal_impact_speed_kmh\":10,\"minimal_gap_m\":1}",
        criteria.with(whole, of(80)).get("accept").toString());
    assertEquals(all + "}", whole.get("accept").toString(), "a case changes no other one");
  }

  /** Entries name more requirements for criteria that have some, and none with other words. */
  @Test
  void whatCriteriaJudgeIsAddedToWhatTheyJudgeAlready() throws IOException {
    ObjectNode scenario = scenario();
    ((ObjectNode) scenario.get("accept"))
        .putObject("judges")
        .putObject("no_impact")
        .put("R-1", "a");
    String entry = "- {accept: {judges: {no_impact: {R-2: b}, stops: {R-3: c}}}}";
    ObjectNode whole = new CriteriaOfCases(plan(entry)).withThoseOfAll(scenario.deepCopy());
    assertEquals(
        "{\"no_impact\":{\"R-1\":\"a\",\"R-2\":\"b\"},\"stops\":{\"R-3\":\"c\"}}",
        whole.at("/accept/judges").toString());
    CriteriaOfCases other =
        new CriteriaOfCases(plan("- {accept: {judges: {no_impact: {R-1: b}}}}"));
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> other.withThoseOfAll(scenario));
    assertTrue(refused.getMessage().contains("'R-1' is \"b\" here, and \"a\" elsewhere"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "{accept: {no_impct: true}}; There is no key 'no_impct' here.",
        "{accept: {formulas: [{formula: always gap > 1}]}}; 1",
        "{where: [speed > 70], accept: {minimal_gap_m: x}}; With speed = 80: ",
        "{where: [speed > 90], accept: {no_impact: true}}; No case of 'c' meets these conditions.",
        "{accept: {no_impact: false}}; 'no_impact' is false here, and true elsewhere",
      })
  void whatNoCaseCanHaveIsFoundBeforeTheFirstOne(String entry, String message) throws IOException {
    CampaignPlan plan = plan("- " + entry);
    CriteriaOfCases criteria = new CriteriaOfCases(plan);
    List<Diagnostic> found =
        new ArrayList<>(CriteriaOfCases.withoutCase(List.of(plan), List.of(plan)));
    found.addAll(criteria.check(new CaseList(plan).cases(), each -> problem(criteria, each)));
    assertEquals(1, found.size(), found::toString);
    assertEquals("campaign.criteria", found.get(0).id());
    assertEquals(5, found.get(0).location().line());
    assertTrue(found.get(0).message().contains(message), found::toString);
  }

  private static Optional<Diagnostic> problem(CriteriaOfCases criteria, CampaignCase each) {
    try {
      ObjectNode whole = criteria.with(criteria.withThoseOfAll(scenario()), each);
      new CaseReader().read(SourceText.of("s.yaml", whole.toPrettyString()), Bench.carla());
      return Optional.empty();
    } catch (DiagnosticException e) {
      return e.diagnostics().stream().filter(CriteriaOfCases::isAbout).findFirst();
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void conditionsThatCannotBeReadAreRefused() throws IOException {
    CampaignPlan plan = plan("- {where: [sped > 1], accept: {no_impact: true}}");
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> new CriteriaOfCases(plan));
    assertTrue(refused.getMessage().contains("[campaign.condition]"), refused::getMessage);
  }
}

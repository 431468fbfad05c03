package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.campaign.result.CampaignPoints;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignSummary;
import dev.eventchain.pipeline.campaign.result.CampaignTable;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the points that protocols count for cases, on results that are not simulated. */
class CampaignPointsTest {

  @TempDir Path folder;

  private static CampaignRow row(double value, Label label, double kmh) {
    OptionalDouble impact = kmh > 0 ? OptionalDouble.of(kmh / 3.6) : OptionalDouble.empty();
    return new CampaignRow(
        new CampaignCase(List.of(BigDecimal.valueOf((long) value)), 1),
        new CaseResult(label, "", List.of(), impact, 1));
  }

  private CampaignPlan plan(String points) throws IOException {
    String text =
        """
        scenario: s
        factors: {speed: {path: x, values: [10, 20, 30, 40, 50]}}
        computed: {half: {path: y, formula: speed / 2}}
        points: %s
        """;
    return CampaignReader.read(Files.writeString(folder.resolve("a.yaml"), text.formatted(points)))
        .get(0);
  }

  @Test
  void pointsAreInTerminalTableJsonAndTests() throws IOException {
    CampaignPlan plan =
        plan(
            "{source: Protocol 1, most: if speed < 45 then 2 else 1,"
                + " at_impact: if impact < half then 0.75 else 0}");
    List<CampaignRow> rows =
        List.of(
            row(10, Label.PASSED, 0),
            row(20, Label.FAILED, 9.9),
            row(30, Label.FAILED, 15.1),
            row(40, Label.FAILED, 0), // Another criterion failed.
            row(50, Label.UNTESTED, 0));
    String text = new CampaignSummary(plan, rows).text().replaceAll(" +", " ");
    assertTrue(
        text.contains("points: 3.5 of 9 (Protocol 1; none for 1 case without a verdict)"), text);
    assertTrue(text.contains("10 passed 2\n"), text);
    assertTrue(text.contains("20 FAILED 1.5\n"), text);
    assertTrue(text.contains("30 FAILED 0\n"), text);
    assertTrue(text.contains("50 untested -\n"), text);
    assertEquals(
        List.of(
            "points: 2 of 2 (Protocol 1)",
            "points: 1.5 of 2 (Protocol 1)",
            "points: 0 of 2 (Protocol 1)",
            "points: 0 of 2 (Protocol 1)",
            "points: - of 1 (Protocol 1)"),
        new CampaignSummary(plan, rows).trials().stream().map(Trial::text).toList());
    assertEquals(
        List.of(
            Map.of("points", "1.5", "most_points", "2", "points_source", "Protocol 1"), Map.of()),
        List.of(1, 4).stream()
            .map(index -> new CampaignSummary(plan, rows).trials().get(index).figures())
            .toList());
    CampaignPoints points = CampaignPoints.of(plan, rows).orElseThrow();
    String table =
        new String(points.in(new CampaignTable(plan.names(), rows)).csv(), StandardCharsets.UTF_8);
    assertTrue(table.startsWith("case,points,most_points,speed,"), table);
    assertTrue(table.contains("\n2,1.5,2,20,"), table);
    assertTrue(table.contains("\n5,,1,50,"), table);
    JsonNode json = new ObjectMapper().readTree(points.json(plan, rows));
    assertEquals("Protocol 1", json.path("source").asText());
    assertEquals(3.5, json.path("points").asDouble());
    assertEquals(9, json.path("most").asDouble());
    assertEquals(1.5, json.at("/cases/1/points").asDouble(), json::toString);
    assertTrue(json.at("/cases/4/points").isMissingNode(), json::toString);
  }

  /**
   * What fails another criterion keeps its points, what fails a named one has 0, and what leaves a
   * named one untested has none, unless its impact left none before.
   */
  @Test
  void pointsDependOnNamedCriteriaAndOnTheCasesOfTheProtocol() throws IOException {
    CampaignPlan plan =
        plan(
            "{source: Protocol 1, most: 2, at_impact: if impact < half then 0.5 else 0,"
                + " criteria: [the lane], where: [speed > 10]}");
    List<CampaignRow> rows =
        List.of(
            judged(10, Label.PASSED, 0, Label.PASSED),
            judged(20, Label.FAILED, 0, Label.PASSED),
            judged(30, Label.FAILED, 0, Label.FAILED),
            judged(40, Label.FAILED, 9, Label.PASSED),
            judged(50, Label.FAILED, 9, Label.UNTESTED),
            judged(50, Label.FAILED, 40, Label.UNTESTED));
    assertEquals(
        List.of(
            "points: none, since the protocol does not have this case (Protocol 1)",
            "points: 2 of 2 (Protocol 1)",
            "points: 0 of 2 (Protocol 1)",
            "points: 1 of 2 (Protocol 1)",
            "points: - of 2 (Protocol 1)",
            "points: 0 of 2 (Protocol 1)"),
        new CampaignSummary(plan, rows).trials().stream().map(Trial::text).toList());
    CampaignPoints points = CampaignPoints.of(plan, rows).orElseThrow();
    assertEquals("3 of 10", points.total());
    assertEquals(
        "Protocol 1; none for 1 case without a verdict; none for 1 case that it does not have",
        points.note());
    String table =
        new String(points.in(new CampaignTable(plan.names(), rows)).csv(), StandardCharsets.UTF_8);
    assertTrue(table.contains("\n1,,,10,"), table);
    JsonNode json = new ObjectMapper().readTree(points.json(plan, rows));
    assertTrue(json.at("/cases/0/most").isMissingNode(), json::toString);
  }

  /** A case to which a named criterion is not given would keep its points, whatever it fails. */
  @Test
  void aCaseWithoutANamedCriterionDependsOnAllThatItHas() throws IOException {
    CampaignPlan plan =
        plan(
            "{source: Protocol 1, most: 2, at_impact: if impact < half then 0.5 else 0,"
                + " criteria: [another one]}");
    List<CampaignRow> rows =
        List.of(
            judged(10, Label.FAILED, 0, Label.FAILED),
            judged(20, Label.PASSED, 0, Label.PASSED),
            judged(30, Label.FAILED, 9, Label.PASSED));
    assertEquals(
        List.of(
            "points: 0 of 2 (Protocol 1)",
            "points: 2 of 2 (Protocol 1)",
            "points: 1 of 2 (Protocol 1)"),
        new CampaignSummary(plan, rows).trials().stream().map(Trial::text).toList());
  }

  private static CampaignRow judged(double value, Label label, double kmh, Label named) {
    CampaignRow row = row(value, label, kmh);
    CriterionMargin criterion =
        new CriterionMargin("the lane is kept (always x)", named, OptionalDouble.empty(), "");
    CaseResult result = row.result();
    return new CampaignRow(
        row.id(), new CaseResult(label, "", List.of(criterion), result.impactSpeed(), 1));
  }

  /** The cells of the suite, at and beside the bounds of the bands, in km/h. */
  @ParameterizedTest
  @CsvSource({
    "ccrs, 10, 0.9, 1", "ccrs, 10, 1.1, 0", "ccrs, 20, 0.9, 2", "ccrs, 25, 4.9, 2",
    "ccrs, 25, 14.9, 1", "ccrs, 25, 15.1, 0", "ccrs, 35, 14.9, 1.5", "ccrs, 35, 24.9, 1",
    "ccrs, 35, 25.1, 0", "ccrs, 45, 24.9, 0.5", "ccrs, 45, 34.9, 0.25", "ccrs, 50, 29.9, 0.5",
    "ccrs, 50, 39.9, 0.25", "ccrs, 50, 40.1, 0", "ccrm, 30, 4.9, 1", "ccrm, 35, 5.1, 0",
    "ccrm, 45, 14.9, 0.5", "ccrm, 50, 14.9, 0.75", "ccrm, 55, 24.9, 0.5", "ccrm, 65, 34.9, 0.5",
    "ccrm, 70, 39.9, 0.5", "ccrm, 75, 44.9, 0.5", "ccrm, 80, 19.9, 1.5", "ccrm, 80, 34.9, 1",
    "ccrm, 80, 49.9, 0.5", "ccrm, 80, 50.1, 0"
  })
  void bandsAreThoseOfTheProtocol(String part, double speed, double impact, double expected) {
    CampaignPlan plan =
        CampaignReader.read(Suites.file("euro-ncap-2023-c2c", folder)).stream()
            .filter(each -> each.part().equals(Optional.of(part)))
            .findFirst()
            .orElseThrow();
    List<BigDecimal> values = List.of(BigDecimal.valueOf(speed), BigDecimal.valueOf(100));
    CaseResult result = row(speed, Label.FAILED, impact).result();
    assertEquals(
        expected,
        plan.score(new CampaignCase(values, 1), result).orElseThrow().points().getAsDouble(),
        1e-12);
  }

  /** A copy of the suite with other cells counts only those of the protocol. */
  @ParameterizedTest
  @CsvSource({
    "ccrs, 10, 100, true", "ccrs, 50, -75, true", "ccrs, 55, 100, false", "ccrs, 12, 100, false",
    "ccrs, 10, 60, false", "ccrs, 10, -100, false", "ccrs, 10, 25, false", "ccrm, 80, 50, true",
    "ccrm, 25, 50, false"
  })
  void casesOfTheProtocolHavePoints(String part, double speed, double overlap, boolean counted) {
    CampaignPlan plan =
        CampaignReader.read(Suites.file("euro-ncap-2023-c2c", folder)).stream()
            .filter(each -> each.part().equals(Optional.of(part)))
            .findFirst()
            .orElseThrow();
    List<BigDecimal> values = List.of(BigDecimal.valueOf(speed), BigDecimal.valueOf(overlap));
    CaseResult result = row(speed, Label.PASSED, 0).result();
    assertEquals(
        counted, plan.score(new CampaignCase(values, 1), result).orElseThrow().isCounted());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "{source: p, most: 30 - speed}; 'most' is no number from 0 on: -10.0.",
        "{source: p, most: 1 / (speed - 30)}; 'most' is no number from 0 on: -0.05.",
        "{source: p, most: 1, at_impact: 1 - impact / 100}; 'at_impact' is not from 0 to 1 at",
        "{source: p, most: 1, at_impact: half}; 'at_impact' is not from 0 to 1 at 0.0 km/h: 5.0."
      })
  void pointsThatNoProtocolCountsAreRefusedBeforeTheFirstCase(String points, String message)
      throws IOException {
    CampaignPlan plan = plan(points);
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> new CaseList(plan).cases());
    assertTrue(refused.getMessage().contains("[campaign.formula]"), refused::getMessage);
    assertTrue(refused.getMessage().contains(message), refused::getMessage);
  }
}

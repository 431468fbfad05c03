package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.Purpose;
import dev.eventchain.simulation.bench.Bench;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests what is checked of campaigns with their scenario before the first case. */
class CampaignWorldTest {

  private static final String SCENARIO =
      """
      name: ahead
      title: A car ahead
      duration_s: 10
      ego: {speed_kmh: 50}
      actors: [{name: car, gap_m: 60, speed_kmh: 0}]
      accept: {maximal_impact_speed_kmh: 30, stops: true}
      """;

  @TempDir Path folder;
  private CampaignWorld world;
  private Path scenario;

  @BeforeEach
  void write() throws IOException {
    Path scenarios = Files.createDirectory(folder.resolve("scenarios"));
    scenario = Files.writeString(scenarios.resolve("ahead.yaml"), SCENARIO);
    Bench bench = Bench.carla();
    world = new CampaignWorld(bench, text -> bench, Optional.empty(), List.of(), scenarios);
  }

  private Path campaign(String text) throws IOException {
    return Files.writeString(folder.resolve("c.yaml"), text);
  }

  private List<String> found(String text) throws IOException {
    return words(world.check(CampaignReader.read(campaign(text))));
  }

  private static List<String> words(List<Diagnostic> found) {
    return found.stream().map(each -> each.id() + " " + each.message()).toList();
  }

  /** A text with a number matches some cases, or none, where a factor is the number. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "any impact is at | [1, 2] |",
        "any impact is at 1 | [1] |",
        "any impact is at 1 | [2, 1] | The text that begins with 'any impact is at 1' changes with 'limit'.",
        "any impact is at 30 | [1, 2] | No criterion of the cases begins with 'any impact is at 30'.",
        "any imapct | [30] | No criterion of the cases begins with 'any imapct'.",
      })
  void pointsDependOnCriteriaThatAllCasesHave(String named, String limits, String message)
      throws IOException {
    String text =
        """
        scenario: ahead
        factors:
          speed: {path: ego.speed_kmh, values: [30, 110]}
          limit: {path: accept.maximal_impact_speed_kmh, values: %s}
        points: {source: P, most: 2, at_impact: 1, criteria: [%s]}
        """;
    assertEquals(
        message == null ? List.of() : List.of("campaign.criteria " + message),
        found(text.formatted(limits, named)));
  }

  /** A case that the protocol does not have may have any criteria. */
  @Test
  void pointsDependOnCriteriaOfTheCasesOfTheProtocol() throws IOException {
    String text =
        """
        scenario: ahead
        factors:
          speed: {path: ego.speed_kmh, values: [30, 60]}
          limit: {path: accept.maximal_impact_speed_kmh, values: [10, 20]}
        criteria: [{where: [speed > 50], accept: {minimal_gap_m: 1}}]
        points: {source: P, most: 2, criteria: [%s], where: [%s]}
        """;
    assertEquals(List.of(), found(text.formatted("any impact is at 10", "limit < 15")));
    assertEquals(List.of(), found(text.formatted("the gap", "speed > 0")));
    assertEquals(
        List.of("campaign.criteria No criterion of the cases begins with 'the gap'."),
        found(text.formatted("the gap", "speed < 50")));
    assertEquals(
        List.of("campaign.criteria No case of 'c' is one of the protocol."),
        found(text.formatted("the gap", "speed > 900")));
  }

  /** Criteria of several campaigns are those of the cases of at least one. */
  @Test
  void criteriaByTagsNeedACaseInOneOfTheirCampaigns() throws IOException {
    String text =
        """
        criteria: [{tags: [t], where: [speed > %s], accept: {minimal_gap_m: 1}}]
        campaigns:
          slow: {tags: [t], scenario: ahead, factors: {speed: {path: ego.speed_kmh, values: [30]}}}
          fast: {tags: [t], scenario: ahead, factors: {speed: {path: ego.speed_kmh, values: [60]}}}
        """;
    assertEquals(List.of(), found(text.formatted(50)));
    assertEquals(
        List.of("campaign.criteria No case of 'c-slow' or 'c-fast' meets these conditions."),
        found(text.formatted(70)));
    List<CampaignPlan> all = CampaignReader.read(campaign(text.formatted(50)));
    assertEquals(List.of(), CriteriaOfCases.withoutCase(all.subList(0, 1), all));
  }

  private ScenarioTemplate searched(String text) throws IOException {
    CampaignPlan plan = CampaignReader.readForSearch(campaign(text)).get(0).ofSearch();
    return new ScenarioTemplate(world, plan, scenario);
  }

  /** The bands of criteria lie between the ends of a range, and there may be many factors. */
  @Test
  void aSearchTriesCasesWithinRanges() throws IOException {
    String band =
        """
        scenario: ahead
        factors: {speed: {path: ego.speed_kmh, uniform: [30, 60]}}
        criteria: [{where: [speed > 40, speed < 50], accept: {%s}}]
        search: {runs: 10}
        """;
    ScenarioTemplate sound = searched(band.formatted("no_brake_at_ttc_s: 3.0"));
    assertEquals(List.of(), sound.check(Purpose.SEARCH));
    assertEquals(2, sound.criteriaOfSearch().size());
    List<Diagnostic> found =
        searched(band.formatted("maximal_impact_speed_kmh: 5")).check(Purpose.SEARCH);
    assertTrue(words(found).toString().contains("'maximal_impact_speed_kmh' is 5 here"));
    assertEquals(
        List.of(),
        world.check(
            CampaignReader.readForSearch(campaign(band.formatted("no_brake_at_ttc_s: 3.0")))));
    String many =
        IntStream.range(0, 20)
            .mapToObj(i -> "f" + i + ": {uniform: [1, 2]}")
            .collect(Collectors.joining(", "));
    String sum = IntStream.range(0, 20).mapToObj(i -> "f" + i).collect(Collectors.joining(" + "));
    assertEquals(
        List.of(),
        searched(
                "scenario: ahead\nfactors: {"
                    + many
                    + "}\ncomputed: {speed: {path: ego.speed_kmh, formula: "
                    + sum
                    + "}}\ncriteria: [{accept: {minimal_gap_m: 1}}]\n")
            .check(Purpose.SEARCH));
  }
}

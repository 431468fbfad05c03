package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.Purpose;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignSummary;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.verdict.CaseResult;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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

  /** Every case has the problem, and only one factor is to blame. */
  @Test
  void aWrongKeyIsSaidOfTheFactorThatHasIt() throws IOException {
    assertEquals(
        List.of("campaign.factor With speed = 30: There is no key 'sped_kmh' here. /ego/sped_kmh"),
        found(
            """
            scenario: ahead
            factors:
              gap: {path: "actors[car].gap_m", values: [40, 50]}
              speed: {path: ego.sped_kmh, values: [30, 60]}
            """));
    assertEquals(
        List.of(
            "campaign.factor With gap = 40: There is no key 'gap_km' here. /actors/0/gap_km",
            "campaign.factor With gap = 40, speed = 30: There is no key 'ofset' here. /ego/ofset"),
        found(
            """
            scenario: ahead
            factors:
              gap: {path: "actors[car].gap_km", values: [40, 50]}
              speed: {path: ego.speed_kmh, values: [30, 60]}
            computed:
              aside: {path: ego.ofset, formula: speed / 100}
            """));
  }

  /** The first values together are no case here, and no scenario takes them. */
  @Test
  void whatTheConditionsLeaveOutIsNotRefused() throws IOException {
    String text =
        """
        scenario: ahead
        factors:
          distance: {values: [5, 20, %s]}
          speed: {path: ego.speed_kmh, values: [30, 60]}
        computed:
          gap: {path: "actors[car].gap_m", formula: distance - 10}
        where: [gap > 0, speed < distance * 2]
        """;
    assertEquals(List.of(), found(text.formatted("40")));
    List<String> far = found(text.formatted("4000"));
    assertEquals(1, far.size(), far::toString);
    assertTrue(far.get(0).startsWith("campaign.factor With distance = 4000"), far::toString);
  }

  /** The key of a topic has slashes, which a place in a file writes otherwise. */
  @Test
  void aWrongKeyOfATopicIsSaidOfTheFactorThatHasIt() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("bench.yaml"),
            """
            provides:
              /scan:
                type: std_msgs/msg/Float32
                rate_hz: 10
                fields: {data: {value: ego.speed, unit: m/s}}
            """);
    MessageCatalog messages = MessageCatalog.of(List.of());
    Function<SourceText, Bench> benches = read -> Bench.parse(read, List.of(), messages);
    world =
        new CampaignWorld(
            benches.apply(SourceText.read(file)),
            benches,
            Optional.of(file),
            List.of(),
            folder.resolve("scenarios"));
    assertEquals(
        List.of(
            "campaign.factor With rate = 5: There is no key 'rate' here. /provides/~1scan/rate"),
        found(
            """
            scenario: ahead
            factors:
              speed: {path: ego.speed_kmh, values: [30, 60]}
              rate: {path: bench:provides./scan.rate, values: [5, 10]}
            """));
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

  /** A text that is the beginning of some criteria does not count as kept for the others. */
  @Test
  void casesWithAnotherLimitThanTheOneThatIsNamedAreFound() throws IOException {
    String text =
        """
        scenario: ahead
        factors: {speed: {path: ego.speed_kmh, values: [30, 60]}}
        criteria:
          - {where: [speed < 50], accept: {minimal_gap_m: 10}}
          - {where: [speed > 50], accept: {minimal_gap_m: %s}}
        points: {source: P, most: 2, criteria: [the gap is never below 1]}
        """;
    assertEquals(List.of(), found(text.formatted(100)));
    assertEquals(
        List.of(
            "campaign.criteria With speed = 60, the criterion is 'the gap is never below 2.00 m',"
                + " which does not begin with 'the gap is never below 1'."),
        found(text.formatted(2)));
  }

  /** Cases may have criteria on different actors, whose names differ in numbers only. */
  @Test
  void aNumberInANameIsNoLimit() throws IOException {
    String text =
        """
        scenario: ahead
        factors: {speed: {path: ego.speed_kmh, values: [30, 60]}}
        criteria:
          - {where: [speed < 50], accept: {formulas: [{formula: "%1$s"}]}}
          - {where: [speed > 50], accept: {formulas: [{formula: "%2$s"}]}}
        points: {source: P, most: 2, criteria: ["%1$s"]}
        """;
    Files.writeString(
        scenario,
        SCENARIO.replace("{name: car,", "{name: car2, gap_m: 90, speed_kmh: 0}, {name: car1,"));
    String gap = "always[%s, 5] actor('%s').gap > %s m";
    String first = gap.formatted("1", "car1", "-1");
    assertEquals(List.of(), found(text.formatted(first, gap.formatted("1", "car2", "-1"))));
    assertEquals(1, found(text.formatted(first, gap.formatted("1", "car1", "-2"))).size());
    assertEquals(1, found(text.formatted(first, gap.formatted("2", "car1", "-1"))).size());
  }

  /** Of more than 201 limits, some are tried before the first case, and all when it is made. */
  @Test
  void aLimitThatWasNotTriedDoesNotCountAsKept() throws IOException {
    String limits =
        IntStream.rangeClosed(0, 400)
            .mapToObj(i -> i == 201 ? "2" : (i < 201 ? "1." : "10.") + (1000 + i))
            .collect(Collectors.joining(", "));
    String text =
        """
        scenario: ahead
        factors: {limit: {path: accept.minimal_gap_m, values: [%s]}}
        points: {source: P, most: 2, criteria: [the gap is never below 1]}
        """;
    Files.writeString(scenario, SCENARIO.replace("stops: true", "minimal_gap_m: 1"));
    assertEquals(List.of(), found(text.formatted(limits)));
    CampaignPlan plan = CampaignReader.read(campaign(text.formatted(limits))).get(0);
    ScenarioTemplate template = new ScenarioTemplate(world, plan, scenario);
    template.of(ofOne("10.1000"));
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> template.of(ofOne("2")));
    assertEquals("campaign.criteria", refused.diagnostics().get(0).id());
    assertTrue(refused.getMessage().contains("With limit = 2, "), refused.getMessage());
  }

  private static CampaignCase ofOne(String value) {
    return new CampaignCase(List.of(new BigDecimal(value)), 1);
  }

  /** Criteria that contradict each other are found wherever their case is met. */
  @Test
  void contradictionsThatOnlyASearchMeetsAreFoundWithBothPlaces() throws IOException {
    String text =
        """
        scenario: ahead
        factors: {speed: {path: ego.speed_kmh, uniform: [30, 60]}}
        criteria:
          - {where: [speed > 44.999, speed < 45], accept: {maximal_impact_speed_kmh: 5}}
          - {where: [speed > 51, speed < 51.001], accept: {minimal_gap_m: 1}}
          - {where: [speed > 51, speed < 51.001], accept: {minimal_gap_m: 2}}
        search: {runs: 10}
        """;
    ScenarioTemplate template = searched(text);
    assertEquals(List.of(), template.check(Purpose.SEARCH));
    List<CampaignRow> rows =
        Stream.of("44.9991", "44.9992", "50", "51.0005")
            .map(speed -> new CampaignRow(ofOne(speed), CaseResult.error("no scenario")))
            .toList();
    CampaignPlan plan = CampaignReader.readForSearch(campaign(text)).get(0).ofSearch();
    List<Diagnostic> found =
        new CampaignSummary(plan, rows, template.ofCriteria(rows))
            .findings(SourceLocation.of(plan.file()));
    assertEquals(
        List.of(
            "campaign.criteria 'maximal_impact_speed_kmh' is 5 here, and 30 elsewhere for the same"
                + " cases.",
            "campaign.criteria 'minimal_gap_m' is 2 here, and 1 elsewhere for the same cases.",
            "campaign.case.error 1 of 4 cases ended by an error, the first is case 3 (speed = 50):"
                + " no scenario."),
        words(found));
    assertEquals(List.of("4 c.yaml ahead.yaml 6", "6 c.yaml c.yaml 5"), places(found));
  }

  private static List<String> places(List<Diagnostic> found) {
    return found.stream()
        .filter(each -> !each.related().isEmpty())
        .map(
            each ->
                each.location().line()
                    + " "
                    + Path.of(each.location().file()).getFileName()
                    + " "
                    + Path.of(each.related().get(0).file()).getFileName()
                    + " "
                    + each.related().get(0).line())
        .toList();
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

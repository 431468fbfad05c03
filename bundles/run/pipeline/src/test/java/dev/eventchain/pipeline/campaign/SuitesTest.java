package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Criterion;
import dev.eventchain.simulation.scenario.CriterionKind;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the files of the suites that come with the program. */
class SuitesTest {

  @TempDir Path folder;

  @Test
  void eachSuiteHasItsScenarios() {
    assertEquals(
        List.of(
            "euro-ncap-2023-c2c",
            "euro-ncap-2023-vru",
            "euro-ncap-2026-ccr",
            "euro-ncap-2026-junction",
            "un-r152",
            "un-r152-pedestrian",
            "un-r157-alks"),
        Suites.names());
    for (String name : Suites.names()) {
      List<CampaignPlan> plans = CampaignReader.read(Suites.file(name, folder));
      assertFalse(plans.isEmpty());
      for (CampaignPlan plan : plans) {
        Scenario scenario = Scenario.read(plan.scenarioFile().orElseThrow(), Bench.carla());
        assertFalse(new CaseList(plan).cases().isEmpty(), plan.name());
        assertTrue(plan.scenario().startsWith(scenario.name() + "."), plan.scenario());
        assertTrue(
            scenario.criteria().stream().anyMatch(each -> !each.isOfEveryScenario()),
            scenario.name());
      }
    }
  }

  @Test
  void theListHasAllCasesOfEachSuite() {
    Suites.Listing list = Suites.list();
    assertEquals(Suites.names(), list.suites().stream().map(Suites.Listing.Suite::name).toList());
    for (Suites.Listing.Suite suite : list.suites()) {
      List<CampaignPlan> plans = CampaignReader.read(Suites.file(suite.name(), folder));
      assertEquals(
          plans.stream().mapToInt(plan -> new CaseList(plan).cases().size()).sum(), suite.cases());
      assertEquals(
          plans.stream().map(plan -> plan.part().orElseThrow()).toList(),
          suite.campaigns().stream().map(Suites.Listing.Part::name).toList());
      assertFalse(suite.source().isBlank());
      assertTrue(
          list.text().contains(suite.cases() + " cases  " + suite.source() + "\n"), list::text);
    }
    Suites.Listing.Part first = list.suites().get(5).campaigns().get(0);
    assertEquals(new Suites.Listing.Part("crossing", "crossing.yaml", 9), first);
    assertTrue(list.json().contains("\"campaigns\": ["), list.json());
    assertEquals(
        "[ccftap 9, cccscp 50, turns_in_a_gap 8, crossed_before 12]",
        list.suites().get(3).campaigns().stream()
            .map(part -> part.name() + " " + part.cases())
            .toList()
            .toString());
  }

  /** A function that always brakes would pass without them. */
  @Test
  void eachSuiteHasCasesInWhichNothingShallBrake() {
    for (String name : Suites.names()) {
      assertTrue(
          CampaignReader.read(Suites.file(name, folder)).stream()
              .map(plan -> Scenario.read(plan.scenarioFile().orElseThrow(), Bench.carla()))
              .flatMap(scenario -> scenario.criteria().stream())
              .anyMatch(
                  each ->
                      each instanceof Criterion known
                          && known.kind() == CriterionKind.NEVER_BRAKES),
          name);
    }
  }

  /** A function that always brakes avoids all impacts, and never has the speed of a test. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "euro-ncap-2023-c2c",
        "euro-ncap-2023-vru",
        "euro-ncap-2026-ccr",
        "euro-ncap-2026-junction",
        "un-r152",
        "un-r152-pedestrian"
      })
  void casesInWhichTheVehicleShallBrakeAreAtTheSpeedOfTheTest(String name) {
    for (CampaignPlan plan : CampaignReader.read(Suites.file(name, folder))) {
      Scenario scenario = Scenario.read(plan.scenarioFile().orElseThrow(), Bench.carla());
      assertTrue(
          Stream.concat(scenario.conditions().stream(), scenario.criteria().stream())
              .map(Expectation::text)
              .anyMatch(
                  text -> text.equals("no braking at all") || text.startsWith("the test speed is")),
          plan.name());
    }
  }
}

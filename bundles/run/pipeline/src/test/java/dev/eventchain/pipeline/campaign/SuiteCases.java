package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertFalse;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.world.Situation;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The cases of suites that come with the program, as they are driven. */
final class SuiteCases {

  private SuiteCases() {}

  /**
   * A case of a campaign.
   *
   * @param words its campaign and its values
   */
  record Case(CampaignCase values, Situation situation, String words) {}

  /**
   * Returns the cases of a campaign of a suite.
   *
   * @param folder where its files are written
   */
  static List<Case> of(String suite, String part, Path folder) {
    Path file = Suites.file(suite, folder);
    CampaignPlan plan =
        CampaignReader.read(file).stream()
            .filter(each -> each.part().equals(Optional.of(part)))
            .findFirst()
            .orElseThrow();
    Bench bench = Bench.carla();
    CampaignWorld world =
        new CampaignWorld(
            bench, text -> bench, Optional.empty(), List.of(), file.resolveSibling("scenarios"));
    ScenarioTemplate template =
        new ScenarioTemplate(world, plan, plan.scenarioFile().orElseThrow());
    List<Case> cases = new ArrayList<>();
    for (CampaignCase each : new CaseList(plan).cases()) {
      Situation situation = template.of(each).scenario().situation();
      cases.add(new Case(each, situation, part + " " + each.words(plan)));
    }
    assertFalse(cases.isEmpty(), part);
    return cases;
  }
}

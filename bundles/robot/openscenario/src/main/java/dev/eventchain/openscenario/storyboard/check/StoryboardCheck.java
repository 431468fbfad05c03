package dev.eventchain.openscenario.storyboard.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Checks a scenario before it is played, as far as no road is needed for that. */
public final class StoryboardCheck {

  private StoryboardCheck() {}

  /**
   * Returns the findings about a scenario, in the order of the file.
   *
   * @param scenario the root
   * @param parameters the names of its parameters
   * @param ego the entity under test
   */
  public static List<Diagnostic> findings(
      ScenarioElement scenario, Set<String> parameters, String ego) {
    Findings findings = new Findings();
    ScenarioElement storyboard = scenario.required("Storyboard");
    SupportCheck support = new SupportCheck(findings, ego);
    support.check(scenario.required("Entities"));
    signals(scenario).ifPresent(support::check);
    support.check(storyboard);
    support.checkControllers(storyboard);
    new ReferenceCheck(findings, scenario, parameters).check();
    ValueCheck values = new ValueCheck(findings);
    values.check(storyboard);
    signals(scenario).ifPresent(values::check);
    new TriggerCheck(findings).check(storyboard);
    boolean hasEgo =
        scenario.required("Entities").children("ScenarioObject").stream()
            .anyMatch(each -> each.text("name").equals(ego));
    if (!hasEgo) {
      findings.add(
          StoryboardRules.UNKNOWN,
          scenario.required("Entities").location(),
          "There is no entity '" + ego + "', which is to be the ego.",
          "Name the entity that is under test.");
    }
    return findings.sorted();
  }

  private static Optional<ScenarioElement> signals(ScenarioElement scenario) {
    return scenario.child("RoadNetwork").flatMap(roads -> roads.child("TrafficSignals"));
  }
}

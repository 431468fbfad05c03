package dev.eventchain.openscenario.storyboard.check;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;

/** Looks for what is written and does nothing. */
final class TriggerCheck {

  private final Findings findings;

  TriggerCheck(Findings findings) {
    this.findings = findings;
  }

  void check(ScenarioElement storyboard) {
    Findings.within(storyboard).forEach(this::checkOne);
  }

  private void checkOne(ScenarioElement element) {
    if (element.name().equals("StartTrigger") && element.children().isEmpty()) {
      findings.add(
          StoryboardRules.EMPTY_TRIGGER,
          element.location(),
          "The start trigger has no condition; it is taken as if it were not there.",
          "Give it a condition, or leave it out.");
    }
    if (element.name().equals("ManeuverGroup") && hasNoActors(element)) {
      Findings.within(element)
          .filter(each -> each.name().equals("PrivateAction"))
          .findFirst()
          .ifPresent(
              action ->
                  findings.add(
                      StoryboardRules.NO_ACTORS,
                      action.location(),
                      "The maneuver group '"
                          + element.text("name")
                          + "' has no actors that could do this.",
                      "Name the actors, or set selectTriggeringEntities."));
    }
  }

  private static boolean hasNoActors(ScenarioElement group) {
    ScenarioElement actors = group.required("Actors");
    return actors.children().isEmpty() && !actors.flag("selectTriggeringEntities", false);
  }
}

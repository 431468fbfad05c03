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
    if (element.name().equals("Act")) {
      boolean byEntities =
          element.child("StartTrigger").stream()
              .flatMap(Findings::within)
              .anyMatch(each -> each.name().equals("TriggeringEntities"));
      element.children("ManeuverGroup").forEach(each -> checkActors(each, byEntities));
    }
  }

  /**
   * Looks for actions of nobody.
   *
   * @param byEntities whether entities trigger the act, which then may be the actors
   */
  private void checkActors(ScenarioElement group, boolean byEntities) {
    ScenarioElement actors = group.required("Actors");
    boolean selects = actors.flag("selectTriggeringEntities", false);
    if (!actors.children().isEmpty() || (selects && byEntities)) {
      return;
    }
    Findings.within(group)
        .filter(each -> each.name().equals("PrivateAction"))
        .findFirst()
        .ifPresent(
            action ->
                findings.add(
                    StoryboardRules.NO_ACTORS,
                    action.location(),
                    "The maneuver group '"
                        + group.text("name")
                        + "' has no actors that could do this.",
                    selects
                        ? "Name the actors, or let a condition on entities start the act."
                        : "Name the actors, or set selectTriggeringEntities."));
  }
}

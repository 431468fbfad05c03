package dev.eventchain.openscenario.storyboard.check;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;

/** Refuses what the storyboard does not support, as the table of features says. */
final class SupportCheck {

  private final Findings findings;
  private final String ego;

  SupportCheck(Findings findings, String ego) {
    this.findings = findings;
    this.ego = ego;
  }

  /** Looks through an element; what is in a refused one is not looked at. */
  void check(ScenarioElement element) {
    if (Feature.isRefused(element.name())) {
      refuse(element.name(), element.name(), element.location());
      return;
    }
    element.values().keySet().stream()
        .sorted()
        .forEach(attribute -> checkAttribute(element, attribute));
    element.children().forEach(this::check);
  }

  private void checkAttribute(ScenarioElement element, String attribute) {
    String name = element.name() + "@" + attribute;
    String value = element.text(attribute);
    if (Feature.isRefused(name)) {
      refuse(name, attribute + " of " + element.name(), element.location(attribute));
    } else if (Feature.isRefused(name + "=" + value)) {
      refuse(
          name + "=" + value,
          attribute + " '" + value + "' of " + element.name(),
          element.location(attribute));
    }
  }

  private void refuse(String feature, String what, SourceLocation place) {
    findings.add(
        StoryboardRules.UNSUPPORTED,
        place,
        "The storyboard does not play " + what + ": " + Feature.all().get(feature).reason() + ".",
        "Leave it out, or say the same by what is supported.");
  }

  /** Refuses to activate controllers of others than the ego, and warns of that of the ego later. */
  void checkControllers(ScenarioElement storyboard) {
    boolean triggeredByEgo =
        Findings.within(storyboard)
            .filter(each -> each.name().equals("TriggeringEntities"))
            .allMatch(this::areEgo);
    Findings.within(storyboard)
        .filter(each -> each.name().equals("Private") || each.name().equals("ManeuverGroup"))
        .forEach(each -> checkActors(each, triggeredByEgo));
  }

  private void checkActors(ScenarioElement holder, boolean triggeredByEgo) {
    boolean onlyEgo =
        holder.name().equals("Private")
            ? holder.text("entityRef").equals(ego)
            : areEgo(holder.required("Actors"))
                && (!holder.required("Actors").flag("selectTriggeringEntities", false)
                    || triggeredByEgo);
    if (onlyEgo && holder.name().equals("Private")) {
      return;
    }
    Findings.within(holder)
        .filter(SupportCheck::activates)
        .forEach(each -> reportActivation(each, onlyEgo));
  }

  private void reportActivation(ScenarioElement action, boolean ofEgo) {
    if (ofEgo) {
      findings.add(
          StoryboardRules.ACTIVATED_LATER,
          action.location(),
          "The controller of '"
              + ego
              + "' is its software, which drives from its first command on, also before this.",
          "Activate it in Init, or take a run in which the software acts before as another test.");
    } else {
      findings.add(
          StoryboardRules.UNSUPPORTED,
          action.location(),
          "The storyboard has no controller but that of the ego, '" + ego + "'.",
          "Leave the controller inactive, and say by actions what the entity does.");
    }
  }

  /** Returns whether all entities that an element names are the ego. */
  private boolean areEgo(ScenarioElement holder) {
    return holder.children("EntityRef").stream()
        .allMatch(each -> each.text("entityRef").equals(ego));
  }

  private static boolean activates(ScenarioElement action) {
    return switch (action.name()) {
      case "AssignControllerAction" ->
          action.flag("activateLongitudinal", false) || action.flag("activateLateral", false);
      case "ActivateControllerAction" ->
          action.flag("longitudinal", false) || action.flag("lateral", false);
      default -> false;
    };
  }
}

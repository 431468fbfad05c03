package dev.eventchain.openscenario.storyboard.check;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Signals;
import dev.eventchain.openscenario.storyboard.tree.Paths;
import dev.eventchain.openscenario.storyboard.world.Entities;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** Looks whether what a storyboard refers to is there. */
final class ReferenceCheck {

  /** Elements that may name a selection of entities. */
  private static final Set<String> OF_MANY = Set.of("EntityRef", "Private", "EntityAction");

  private final Findings findings;
  private final ScenarioElement scenario;
  private final Set<String> parameters;
  private final Entities entities;
  private final Signals signals;
  private final Paths paths;

  ReferenceCheck(Findings findings, ScenarioElement scenario, Set<String> parameters) {
    this.parameters = parameters;
    this.findings = findings;
    this.scenario = scenario;
    entities = Entities.of(scenario);
    signals = Signals.of(scenario);
    paths = new Paths(scenario.required("Storyboard"));
  }

  void check() {
    Stream.concat(
            Findings.within(scenario.required("Entities")),
            Findings.within(scenario.required("Storyboard")))
        .forEach(this::check);
  }

  private void check(ScenarioElement element) {
    for (String attribute : List.of("entityRef", "masterEntityRef")) {
      element.optional(attribute).ifPresent(name -> checkEntity(element, attribute, name));
    }
    checkDeclared(element, "parameterRef", "parameter", parameters);
    checkDeclared(element, "variableRef", "variable", variables());
    if (element.has("trafficSignalControllerRef") && element.has("phase")) {
      String controller = element.text("trafficSignalControllerRef");
      if (!signals.knows(controller, element.text("phase"))) {
        findings.add(
            StoryboardRules.UNKNOWN,
            element.location("trafficSignalControllerRef"),
            "There is no controller '"
                + controller
                + "' with a phase '"
                + element.text("phase")
                + "'.",
            "Declare it in the TrafficSignals of the RoadNetwork.");
      }
    }
    if (element.name().equals("StoryboardElementStateCondition")) {
      checkElement(element);
    }
  }

  private void checkEntity(ScenarioElement element, String attribute, String name) {
    boolean known =
        OF_MANY.contains(element.name()) ? entities.knows(name) : entities.find(name).isPresent();
    if (!known) {
      String more = entities.knows(name) ? ", but a selection of entities." : ".";
      unknown(element, attribute, "'" + name + "' is no entity" + more, name, entities());
    }
  }

  private Collection<String> entities() {
    return entities.objects().keySet();
  }

  private List<String> variables() {
    return scenario.child("VariableDeclarations").stream()
        .flatMap(each -> each.children().stream())
        .map(each -> each.text("name"))
        .toList();
  }

  private void checkDeclared(
      ScenarioElement element, String attribute, String kind, Collection<String> names) {
    element
        .optional(attribute)
        .filter(name -> !names.contains(name))
        .ifPresent(
            name ->
                unknown(
                    element,
                    attribute,
                    "The scenario declares no " + kind + " '" + name + "'.",
                    name,
                    names));
  }

  private void checkElement(ScenarioElement condition) {
    String reference = condition.text("storyboardElementRef");
    String type = condition.text("storyboardElementType");
    List<String> found = paths.find(type, reference);
    if (found.isEmpty()) {
      unknown(
          condition,
          "storyboardElementRef",
          "There is no " + type + " '" + reference + "' in the storyboard.",
          reference,
          paths.names(type));
    } else if (found.size() > 1) {
      findings.add(
          StoryboardRules.AMBIGUOUS,
          condition.location("storyboardElementRef"),
          "'" + reference + "' may be " + String.join(" or ", found) + ".",
          "Name the elements around it, separated by '::', or give each a name of its own.");
    }
  }

  private void unknown(
      ScenarioElement element,
      String attribute,
      String message,
      String name,
      Collection<String> names) {
    String hint =
        NearestName.of(name, names)
            .map(each -> "Did you mean '" + each + "'?")
            .orElse("Declare it, or correct the name.");
    findings.add(StoryboardRules.UNKNOWN, element.location(attribute), message, hint);
  }
}

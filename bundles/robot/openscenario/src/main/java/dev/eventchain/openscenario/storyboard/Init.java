package dev.eventchain.openscenario.storyboard;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.action.Actions;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * The actions before the storyboard. Entities are placed first, those before others that are placed
 * relative to them; all other actions follow in the order of the file.
 */
final class Init {

  /** An action with the entities that do it. */
  private record Given(ScenarioElement action, List<String> actors) {

    boolean places() {
      return !action.children().isEmpty()
          && (action.choice().name().equals("TeleportAction")
              || action.choice().children().stream()
                  .anyMatch(each -> each.name().equals("AddEntityAction")));
    }

    /** Returns the names of the entities to which its place is relative. */
    Set<String> references() {
      Set<String> names = new LinkedHashSet<>();
      ScenarioElement kind = action.choice();
      (kind.name().equals("TeleportAction") ? kind.children() : kind.choice().children())
          .forEach(each -> addReferences(each, names));
      return names;
    }

    private static void addReferences(ScenarioElement element, Set<String> names) {
      element.optional("entityRef").ifPresent(names::add);
      element.children().forEach(each -> addReferences(each, names));
    }
  }

  private final Scene scene;
  private final List<Given> actions = new ArrayList<>();

  Init(ScenarioElement storyboard, Scene scene) {
    this.scene = scene;
    ScenarioElement written = storyboard.required("Init").required("Actions");
    for (ScenarioElement each : written.children()) {
      if (each.name().equals("Private")) {
        List<String> actors = scene.entities().named(each.text("entityRef"));
        each.children("PrivateAction").forEach(action -> actions.add(new Given(action, actors)));
      } else {
        actions.add(new Given(each, actors(each)));
      }
    }
  }

  /** Returns the entities that an action without actors adds or deletes. */
  private List<String> actors(ScenarioElement action) {
    return action.child("EntityAction").stream()
        .flatMap(each -> scene.entities().named(each.text("entityRef")).stream())
        .toList();
  }

  void run() {
    List<Given> places = new ArrayList<>(actions.stream().filter(Given::places).toList());
    while (!places.isEmpty()) {
      Given next =
          places.stream()
              .filter(each -> waitsFor(each, places).findAny().isEmpty())
              .findFirst()
              .orElseThrow(() -> circle(places.get(0), places));
      Actions.read(next.action()).start(scene, next.actors());
      places.remove(next);
    }
    for (Given each : actions) {
      if (!each.places()) {
        Actions.read(each.action()).start(scene, each.actors());
      }
    }
  }

  private static Stream<String> waitsFor(Given action, List<Given> places) {
    return action.references().stream()
        .filter(
            each ->
                places.stream()
                    .anyMatch(other -> !other.equals(action) && other.actors().contains(each)));
  }

  private static DiagnosticException circle(Given action, List<Given> places) {
    return StoryboardRules.failure(
        StoryboardRules.CIRCLE,
        String.join(", ", action.actors())
            + " and "
            + String.join(", ", waitsFor(action, places).toList())
            + " are placed relative to each other.",
        action.action().location(),
        "Give one of them a position of its own.");
  }
}

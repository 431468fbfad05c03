package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** A trigger: one of its groups holds, in which all conditions hold. */
public final class Trigger {

  private final List<List<Condition>> groups = new ArrayList<>();

  /**
   * Reads a trigger.
   *
   * @param elements finds the paths of elements of the storyboard
   */
  public Trigger(ScenarioElement written, ElementPaths elements) {
    for (ScenarioElement group : written.children("ConditionGroup")) {
      groups.add(
          group.children("Condition").stream()
              .map(each -> new Condition(each, Tests.read(each, elements)))
              .toList());
    }
  }

  /** Forgets what its conditions were, at the begin of a time in which it counts. */
  public void reset() {
    groups.forEach(group -> group.forEach(Condition::reset));
  }

  /** Returns what it is now. All conditions are looked at, since each remembers what it was. */
  public Outcome in(Scene scene) {
    boolean holds = false;
    Set<String> entities = new LinkedHashSet<>();
    for (List<Condition> group : groups) {
      List<Outcome> outcomes = group.stream().map(each -> each.in(scene)).toList();
      if (outcomes.stream().allMatch(Outcome::holds)) {
        holds = true;
        outcomes.forEach(each -> entities.addAll(each.entities()));
      }
    }
    return holds ? new Outcome(true, List.copyOf(entities)) : Outcome.NO;
  }
}

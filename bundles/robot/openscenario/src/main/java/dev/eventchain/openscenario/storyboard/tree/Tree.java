package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.action.Actions;
import dev.eventchain.openscenario.storyboard.condition.ElementPaths;
import dev.eventchain.openscenario.storyboard.condition.Outcome;
import dev.eventchain.openscenario.storyboard.condition.Trigger;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * The stories of a storyboard and its stop trigger.
 *
 * <p>In a step, first all entities move. Then the stop trigger is looked at, and the elements in
 * the order of the file: an act's stop trigger before its start trigger, the end of what is in an
 * element before its own. That is repeated until nothing changes, so that a condition on an element
 * sees what happens to it in the same step, wherever it stands. Each event starts at most once in a
 * step.
 */
public final class Tree {

  private final List<Branch> stories = new ArrayList<>();
  private final Optional<Trigger> stop;
  private final ElementPaths paths;
  private final Log log;
  private boolean stopped;

  /** Reads a storyboard. */
  public Tree(ScenarioElement storyboard, Log log) {
    this.log = log;
    paths = new Paths(storyboard);
    stop = trigger(storyboard, "StopTrigger");
    Names names = new Names("");
    for (ScenarioElement each : storyboard.children("Story")) {
      stories.add(story(each, names.path(each)));
    }
  }

  /** Returns the trigger of an element; empty if it has none, or one without a condition. */
  private Optional<Trigger> trigger(ScenarioElement element, String name) {
    return element
        .child(name)
        .filter(each -> !each.children().isEmpty())
        .map(each -> new Trigger(each, paths));
  }

  private Branch story(ScenarioElement written, String path) {
    Branch story = new Branch(path, "story", log);
    Names names = new Names(path + "/");
    for (ScenarioElement each : written.children("Act")) {
      story.add(act(each, names.path(each)));
    }
    return story;
  }

  private Act act(ScenarioElement written, String path) {
    Act act = new Act(path, log, trigger(written, "StartTrigger"), trigger(written, "StopTrigger"));
    Names names = new Names(path + "/");
    for (ScenarioElement each : written.children("ManeuverGroup")) {
      act.add(group(each, names.path(each)));
    }
    return act;
  }

  private Group group(ScenarioElement written, String path) {
    Group group = new Group(path, log, written.integer("maximumExecutionCount"));
    Function<Outcome, List<String>> actors = actors(written.required("Actors"));
    Names names = new Names(path + "/");
    for (ScenarioElement each : written.children("Maneuver")) {
      group.add(maneuver(each, names.path(each), actors));
    }
    return group;
  }

  private Function<Outcome, List<String>> actors(ScenarioElement written) {
    Scene scene = log.scene();
    List<String> named =
        written.children("EntityRef").stream()
            .flatMap(each -> scene.entities().named(each.text("entityRef")).stream())
            .toList();
    return written.flag("selectTriggeringEntities")
        ? outcome -> joined(named, outcome.entities())
        : outcome -> named;
  }

  private static List<String> joined(List<String> first, List<String> second) {
    List<String> all = new ArrayList<>(first);
    second.stream().filter(each -> !first.contains(each)).forEach(all::add);
    return all;
  }

  private Branch maneuver(
      ScenarioElement written, String path, Function<Outcome, List<String>> actors) {
    Branch maneuver = new Branch(path, "maneuver", log);
    Names names = new Names(path + "/");
    for (ScenarioElement each : written.children("Event")) {
      maneuver.add(event(each, names.path(each), maneuver, actors));
    }
    return maneuver;
  }

  private Event event(
      ScenarioElement written,
      String path,
      Branch maneuver,
      Function<Outcome, List<String>> actors) {
    Event.Priority priority =
        switch (written.text("priority")) {
          case "parallel" -> Event.Priority.PARALLEL;
          case "skip" -> Event.Priority.SKIP;
          default -> Event.Priority.OVERRIDE;
        };
    int most = written.has("maximumExecutionCount") ? written.integer("maximumExecutionCount") : 1;
    Event event = new Event(path, log, maneuver, priority, most, trigger(written, "StartTrigger"));
    Names names = new Names(path + "/");
    for (ScenarioElement each : written.children("Action")) {
      event.add(new ActionNode(names.path(each), log, Actions.read(each.choice()), actors));
    }
    return event;
  }

  /** Starts all stories. */
  public void start() {
    stories.forEach(each -> each.enter(new Outcome(true, List.of())));
    settle();
  }

  /** Lets all happen that happens at this moment. */
  public void settle() {
    boolean changed = true;
    while (changed && !stopped) {
      if (stop.isPresent() && stop.get().in(log.scene()).holds()) {
        stopped = true;
        stories.forEach(Node::stop);
        return;
      }
      changed = false;
      for (Branch each : stories) {
        changed |= each.update();
      }
    }
  }

  /** Returns whether it has a stop trigger that can hold. */
  public boolean hasStop() {
    return stop.isPresent();
  }

  /** Returns whether the stop trigger held, or all stories of one without a stop are complete. */
  public boolean ended() {
    return stopped
        || (stop.isEmpty() && !stories.isEmpty() && stories.stream().allMatch(Node::isComplete));
  }
}

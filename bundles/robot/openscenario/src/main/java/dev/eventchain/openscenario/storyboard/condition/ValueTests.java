package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Surroundings;
import dev.eventchain.openscenario.storyboard.scene.Values;
import dev.eventchain.openscenario.storyboard.world.Progress;
import java.time.LocalDateTime;
import java.time.format.DateTimeParseException;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** Expressions on values. */
final class ValueTests {

  private ValueTests() {}

  static Test read(ScenarioElement condition, ElementPaths elements) {
    return switch (condition.name()) {
      case "ParameterCondition" -> value(condition, "parameterRef", Scene::parameters);
      case "VariableCondition" -> value(condition, "variableRef", Scene::variables);
      case "SimulationTimeCondition" -> time(condition);
      case "TimeOfDayCondition" -> timeOfDay(condition);
      case "StoryboardElementStateCondition" -> state(condition, elements);
      case "TrafficSignalCondition" -> signal(condition);
      case "TrafficSignalControllerCondition" -> controller(condition);
      default -> throw new IllegalArgumentException(condition.name() + " is not supported");
    };
  }

  private static Test signal(ScenarioElement condition) {
    String name = condition.text("name");
    String state = condition.text("state");
    return scene ->
        Outcome.of(scene.signals().state(name, scene.time()).filter(state::equals).isPresent());
  }

  private static Test controller(ScenarioElement condition) {
    String name = condition.text("trafficSignalControllerRef");
    String phase = condition.text("phase");
    return scene -> Outcome.of(scene.signals().isIn(name, phase, scene.time()));
  }

  private static Test value(
      ScenarioElement condition, String reference, Function<Scene, Values> values) {
    Comparison rule = Comparison.of(condition);
    String name = condition.text(reference);
    String value = condition.text("value");
    return scene -> Outcome.of(compares(rule, values.apply(scene).get(name), value));
  }

  /** Compares as numbers what both are, as dates likewise, and as text all else. */
  private static boolean compares(Comparison rule, String actual, String value) {
    Optional<Double> first = Values.parsed(actual);
    Optional<Double> second = Values.parsed(value);
    if (first.isPresent() && second.isPresent()) {
      return rule.holds(first.get(), second.get());
    }
    try {
      return rule.holds(Surroundings.date(actual).compareTo(Surroundings.date(value)));
    } catch (DateTimeParseException e) {
      return rule.holds(actual.compareTo(value));
    }
  }

  private static Test time(ScenarioElement condition) {
    Comparison rule = Comparison.of(condition);
    double value = condition.number("value");
    return scene -> Outcome.of(rule.holds(scene.time(), value));
  }

  private static Test timeOfDay(ScenarioElement condition) {
    Comparison rule = Comparison.of(condition);
    LocalDateTime value = Surroundings.date(condition.text("dateTime"));
    return scene ->
        Outcome.of(
            scene
                .surroundings()
                .timeOfDay()
                .filter(now -> rule.holds(now.compareTo(value)))
                .isPresent());
  }

  private static Test state(ScenarioElement condition, ElementPaths elements) {
    List<String> paths =
        elements.find(
            condition.text("storyboardElementType"), condition.text("storyboardElementRef"));
    String state = condition.text("state");
    if (paths.size() != 1) {
      throw new IllegalArgumentException(paths + " are not one element");
    }
    String path = paths.get(0);
    return scene -> Outcome.of(is(state, scene.progress(path), scene.step()));
  }

  private static boolean is(String state, Progress now, long step) {
    return switch (state) {
      case "standbyState" -> now.state() == Progress.State.STANDBY;
      case "runningState" -> now.state() == Progress.State.RUNNING;
      case "completeState" -> now.state() == Progress.State.COMPLETE;
      case "startTransition" -> now.is(Progress.Transition.START, step);
      case "endTransition" -> now.is(Progress.Transition.END, step);
      case "stopTransition" -> now.is(Progress.Transition.STOP, step);
      case "skipTransition" -> now.is(Progress.Transition.SKIP, step);
      default -> throw new IllegalArgumentException(state);
    };
  }
}

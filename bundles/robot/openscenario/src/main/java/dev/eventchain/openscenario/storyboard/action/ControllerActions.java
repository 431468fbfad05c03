package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import java.util.Optional;

/** Controllers that are assigned or activated; what was active once stays so. */
final class ControllerActions {

  private ControllerActions() {}

  static PrivateAction read(ScenarioElement action) {
    return switch (action.name()) {
      case "AssignControllerAction" ->
          activation(action, "activateLongitudinal", "activateLateral");
      case "ActivateControllerAction" -> activation(action, "longitudinal", "lateral");
      default -> throw new IllegalArgumentException(action.name() + " is not supported");
    };
  }

  private static PrivateAction activation(ScenarioElement action, String speed, String way) {
    boolean speedActive = action.flag(speed, false);
    boolean wayActive = action.flag(way, false);
    return (Scene scene, Actor actor) -> {
      actor.activate(speedActive, wayActive);
      return Optional.<Task>empty();
    };
  }
}

package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;

/** Reads actions. */
public final class Actions {

  private Actions() {}

  /**
   * Reads the content of an {@code Action}, or an action of {@code Init}.
   *
   * @throws IllegalArgumentException for one that is not supported, which a check has refused
   */
  public static Action read(ScenarioElement action) {
    switch (action.name()) {
      case "GlobalAction":
        return GlobalActions.read(action.choice());
      case "PrivateAction":
        return ofEntity(action.choice());
      case "UserDefinedAction":
        return Action.NONE;
      default:
        throw new IllegalArgumentException(action.name() + " is no action");
    }
  }

  private static Action ofEntity(ScenarioElement action) {
    switch (action.name()) {
      case "LongitudinalAction":
        return longitudinal(action.choice());
      case "TeleportAction":
        return TeleportActions.read(action);
      case "VisibilityAction":
        return TeleportActions.visibility(action);
      case "AppearanceAction":
        return Action.NONE;
      default:
        throw new IllegalArgumentException(action.name() + " is not supported");
    }
  }

  private static Action longitudinal(ScenarioElement action) {
    switch (action.name()) {
      case "SpeedAction":
        return SpeedActions.read(action);
      default:
        throw new IllegalArgumentException(action.name() + " is not supported");
    }
  }
}

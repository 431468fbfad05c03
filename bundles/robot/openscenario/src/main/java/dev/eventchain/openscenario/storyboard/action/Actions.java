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
    return switch (action.name()) {
      case "GlobalAction" -> GlobalActions.read(action.choice());
      case "PrivateAction" -> ofEntity(action.choice()).ofEach();
      case "UserDefinedAction" -> Action.NONE;
      default -> throw new IllegalArgumentException(action.name() + " is no action");
    };
  }

  private static PrivateAction ofEntity(ScenarioElement action) {
    return switch (action.name()) {
      case "LongitudinalAction" -> longitudinal(action.choice());
      case "LateralAction" -> lateral(action.choice());
      case "RoutingAction" -> RoutingActions.read(action.choice());
      case "SynchronizeAction" -> Synchronizing.read(action);
      case "ControllerAction" -> controllers(action);
      case "ActivateControllerAction" -> controller(action);
      case "TeleportAction" -> TeleportActions.read(action);
      case "VisibilityAction" -> TeleportActions.visibility(action);
      case "AppearanceAction" -> PrivateAction.NONE;
      default -> throw new IllegalArgumentException(action.name() + " is not supported");
    };
  }

  /** Reads all actions of an element, which before 1.1 may have more than one. */
  private static PrivateAction controllers(ScenarioElement action) {
    action.children().forEach(Actions::controller);
    return PrivateAction.NONE;
  }

  /**
   * Reads an action of a controller: that of the ego is its software, from the first command on.
   */
  private static PrivateAction controller(ScenarioElement action) {
    return switch (action.name()) {
      case "AssignControllerAction", "ActivateControllerAction" -> PrivateAction.NONE;
      default -> throw new IllegalArgumentException(action.name() + " is not supported");
    };
  }

  private static PrivateAction longitudinal(ScenarioElement action) {
    return switch (action.name()) {
      case "SpeedAction" -> SpeedActions.read(action);
      case "SpeedProfileAction" -> SpeedProfile.read(action);
      case "LongitudinalDistanceAction" -> LongitudinalDistance.read(action);
      default -> throw new IllegalArgumentException(action.name() + " is not supported");
    };
  }

  private static PrivateAction lateral(ScenarioElement action) {
    return switch (action.name()) {
      case "LaneChangeAction" -> LateralActions.laneChange(action);
      case "LaneOffsetAction" -> LateralActions.laneOffset(action);
      case "LateralDistanceAction" -> LateralDistance.read(action);
      default -> throw new IllegalArgumentException(action.name() + " is not supported");
    };
  }
}

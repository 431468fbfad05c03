package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import java.util.List;

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
      case "LateralAction":
        return lateral(action.choice());
      case "RoutingAction":
        return RoutingActions.read(action.choice());
      case "SynchronizeAction":
        return Synchronizing.read(action);
      case "ControllerAction":
        return controllers(action);
      case "ActivateControllerAction":
        return ControllerActions.read(action);
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
      case "SpeedProfileAction":
        return SpeedProfile.read(action);
      case "LongitudinalDistanceAction":
        return LongitudinalDistance.read(action);
      default:
        throw new IllegalArgumentException(action.name() + " is not supported");
    }
  }

  private static Action lateral(ScenarioElement action) {
    switch (action.name()) {
      case "LaneChangeAction":
        return LateralActions.laneChange(action);
      case "LaneOffsetAction":
        return LateralActions.laneOffset(action);
      case "LateralDistanceAction":
        return LateralDistance.read(action);
      default:
        throw new IllegalArgumentException(action.name() + " is not supported");
    }
  }

  /** Returns all actions of an element, which before 1.1 may have more than one. */
  private static Action controllers(ScenarioElement action) {
    List<PrivateAction> all = action.children().stream().map(ControllerActions::read).toList();
    return (scene, actors) -> {
      all.forEach(each -> each.start(scene, actors));
      return List.of();
    };
  }
}

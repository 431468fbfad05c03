package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.document.ScenarioElement;

/** Reads positions. */
public final class Positions {

  private Positions() {}

  /**
   * Reads an element whose only child says the kind of position.
   *
   * @throws IllegalArgumentException for one that is not supported, which a check has refused
   */
  public static Position read(ScenarioElement element) {
    ScenarioElement position = element.choice();
    switch (position.name()) {
      case "WorldPosition":
        return WorldPositions.absolute(position);
      case "RelativeWorldPosition":
        return WorldPositions.relative(position);
      case "RelativeObjectPosition":
        return WorldPositions.ofObject(position);
      case "GeoPosition":
        return WorldPositions.geo(position);
      case "RoadPosition":
        return RoadPositions.absolute(position);
      case "RelativeRoadPosition":
        return RoadPositions.relative(position);
      case "LanePosition":
        return LanePositions.absolute(position);
      case "RelativeLanePosition":
        return LanePositions.relative(position);
      default:
        throw new IllegalArgumentException(position.name() + " is no position");
    }
  }
}

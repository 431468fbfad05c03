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
    return switch (position.name()) {
      case "WorldPosition" -> WorldPositions.absolute(position);
      case "RelativeWorldPosition" -> WorldPositions.relative(position);
      case "RelativeObjectPosition" -> WorldPositions.ofObject(position);
      case "RoutePosition" -> RoutePositions.read(position);
      case "TrajectoryPosition" -> TrajectoryPositions.read(position);
      case "GeoPosition" -> WorldPositions.geo(position);
      case "RoadPosition" -> RoadPositions.absolute(position);
      case "RelativeRoadPosition" -> RoadPositions.relative(position);
      case "LanePosition" -> LanePositions.absolute(position);
      case "RelativeLanePosition" -> LanePositions.relative(position);
      default -> throw new IllegalArgumentException(position.name() + " is no position");
    };
  }
}

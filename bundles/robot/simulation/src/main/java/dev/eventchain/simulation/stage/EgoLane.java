package dev.eventchain.simulation.stage;

import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.roads.LanePath;
import dev.eventchain.roads.LanePosition;
import dev.eventchain.roads.RoadNetwork;
import dev.eventchain.simulation.world.Road;
import java.util.List;

/**
 * The lane in which the ego starts, and those that follow it, as the road of the world. Nothing
 * stands beside it but what the road map has.
 *
 * @param path along the middle of the lanes
 * @param start of the road on the path, in m
 */
record EgoLane(RoadNetwork roads, LanePath path, double start, Frame frame) implements Road {

  @Override
  public boolean isStraight() {
    return false;
  }

  @Override
  public boolean isFurnished() {
    return false;
  }

  @Override
  public Place place(double along, double across) {
    dev.eventchain.roads.road.Pose pose = path.pose(start + along, across);
    return frame.toWorld(Pose.flat(pose.x(), pose.y(), pose.heading()));
  }

  @Override
  public Station station(double x, double y, double near) {
    Pose pose = frame.toMap(new Place(x, y, 0.0));
    LanePath.Station station = path.station(pose.x(), pose.y(), start + near);
    return new Station(station.along() - start, station.across());
  }

  @Override
  public double heading(double along) {
    return StrictMath.IEEEremainder(path.heading(start + along) - frame.heading(), 2.0 * Math.PI);
  }

  @Override
  public double curvature(double along) {
    return path.curvature(start + along);
  }

  @Override
  public double laneWidth(double along) {
    LanePosition at = path.lanePosition(start + along);
    return roads
        .road(at.road())
        .map(road -> road.section(at.s()).width(at.lane(), at.s()))
        .orElse(USUAL_LANE_WIDTH);
  }

  @Override
  public double wall(Place from, double dx, double dy) {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public List<Line> lines(double from, double to) {
    return LaneLines.of(roads, this, from, to);
  }
}

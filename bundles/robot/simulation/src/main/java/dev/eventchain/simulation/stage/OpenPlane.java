package dev.eventchain.simulation.stage;

import dev.eventchain.simulation.world.Road;

/** A plane without roads: its x axis stands for the road. */
record OpenPlane() implements Road {

  @Override
  public boolean isStraight() {
    return true;
  }

  @Override
  public boolean isFurnished() {
    return false;
  }

  @Override
  public Place place(double along, double across) {
    return new Place(along, across, 0.0);
  }

  @Override
  public Station station(double x, double y, double near) {
    return new Station(x, y);
  }

  @Override
  public double heading(double along) {
    return 0.0;
  }

  @Override
  public double curvature(double along) {
    return 0.0;
  }

  @Override
  public double laneWidth(double along) {
    return USUAL_LANE_WIDTH;
  }

  @Override
  public double wall(Place from, double dx, double dy) {
    return Double.POSITIVE_INFINITY;
  }
}

package dev.eventchain.openscenario.storyboard.world;

/**
 * A point in the coordinates of a lane.
 *
 * @param lane the number of the lane, positive to the left of the reference line, never 0
 * @param s along the road's reference line, in m
 * @param offset to the left of the lane's centre as one looks along s, in m
 */
public record LanePoint(String road, int lane, double s, double offset) {

  public LanePoint withOffset(double newOffset) {
    return new LanePoint(road, lane, s, newOffset);
  }
}

package dev.eventchain.roads;

/**
 * A place by the middle of a lane, as OpenSCENARIO gives it.
 *
 * @param road the id of the road
 * @param lane the id of the lane: positive left of the reference line, negative right of it
 * @param s the distance along the reference line, in m
 * @param offset the distance to the lane's middle, in the direction of t, in m
 */
public record LanePosition(String road, int lane, double s, double offset) {}

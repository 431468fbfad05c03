package dev.eventchain.roads;

import java.util.OptionalInt;

/**
 * A place by the coordinates of a road.
 *
 * @param road the id of the road
 * @param s the distance along the reference line, in m
 * @param t the distance to the reference line, positive to the left, in m
 * @param lane the lane there, 0 for none; empty beside the outermost lanes
 */
public record RoadPosition(String road, double s, double t, OptionalInt lane) {}

package dev.eventchain.openscenario.storyboard.world;

/**
 * A point in the coordinates of a road.
 *
 * @param s along the reference line, in m
 * @param t to the left of the reference line, in m
 */
public record RoadPoint(String road, double s, double t) {}

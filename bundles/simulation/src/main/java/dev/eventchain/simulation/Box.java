package dev.eventchain.simulation;

/**
 * A solid on the road, its sides along and across the lane, in the ego's frame: x forward from the
 * front bumper, y left from the centre line, z up from the road; all in m.
 */
record Box(double rear, double front, double right, double left, double height, float intensity) {}

package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.Optional;

/**
 * Where a position is.
 *
 * @param road the point of a road; empty off the roads
 */
public record Placement(Pose pose, Optional<LanePoint> road) {}

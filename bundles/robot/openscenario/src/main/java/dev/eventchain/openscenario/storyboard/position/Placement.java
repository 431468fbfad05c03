package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.Optional;

/**
 * Place of a position.
 *
 * @param road the point of a road; empty off the roads
 */
public record Placement(Pose pose, Optional<LanePoint> road) {}

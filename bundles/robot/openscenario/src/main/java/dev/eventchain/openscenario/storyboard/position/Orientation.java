package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.world.Pose;

/**
 * The orientation of a position, in rad.
 *
 * @param relative whether it counts from a reference
 */
record Orientation(double heading, double pitch, double roll, boolean relative) {

  private static final Orientation AS_REFERENCE = new Orientation(0, 0, 0, true);

  /** Reads that of a position; the orientation of the reference if it has none. */
  static Orientation of(ScenarioElement position) {
    return position
        .child("Orientation")
        .map(
            each ->
                new Orientation(
                    each.number("h", 0),
                    each.number("p", 0),
                    each.number("r", 0),
                    each.optional("type").orElse("absolute").equals("relative")))
        .orElse(AS_REFERENCE);
  }

  /** Returns a place with this orientation. */
  Pose at(Pose place, Pose reference) {
    double from = relative ? 1 : 0;
    return new Pose(
            place.x(),
            place.y(),
            place.z(),
            0,
            from * reference.pitch() + pitch,
            from * reference.roll() + roll)
        .withHeading(from * reference.heading() + heading);
  }
}

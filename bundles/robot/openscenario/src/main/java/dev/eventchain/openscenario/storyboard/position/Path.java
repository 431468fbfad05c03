package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.OptionalDouble;

/** A way in the world. Immutable. */
public interface Path {

  /** Returns its length in m. */
  double length();

  /** Returns the pose after a way along it, from 0 to its length. */
  Pose pose(double way);

  /** Returns the direction of the way there, in rad: the heading, unless its points say another. */
  default double direction(double way) {
    return pose(way).heading();
  }

  /** Returns whether its points have times. */
  boolean isTimed();

  /** Returns the time of the last point, in s; of a path with times. */
  double end();

  /** Returns the way at a time; 0 before the first time, the length after the last. */
  double way(double time);

  /** Returns the speed along it at a time, in m/s; at a corner that after it. */
  double speed(double time);

  /** Returns the way to the point of it that is nearest to a place, and not far off. */
  OptionalDouble nearest(Pose place);
}

package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.List;

/** Paths from point to point. */
public final class Paths {

  private Paths() {}

  /** Returns the path of straight lines between at least two points. */
  public static Path through(List<Pose> points) {
    return new Polyline(points, new double[0]);
  }
}

package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.position.Path;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;

/**
 * The speed of a path with times.
 *
 * @param offset what is added to the times of the path, in s
 * @param scale what they are multiplied by
 * @param now the time, from the begin of the action or of the simulation
 */
record TimedWay(Path path, double offset, double scale, double now) implements Longitudinal {

  @Override
  public Step step(Scene scene, Actor actor, double dt) {
    double after = now + dt;
    boolean done = inPath(after) >= path.end() - SpeedChange.NOTHING;
    double speed = speedIn(done ? path.end() : inPath(after));
    double distance = path.way(inPath(after)) - path.way(inPath(now));
    return new Step(
        distance,
        speed,
        (speed - actor.state().speed()) / dt,
        new TimedWay(path, offset, scale, after),
        done);
  }

  private double inPath(double time) {
    return (time - offset) / scale;
  }

  /** Returns the speed, in simulated time. */
  private double speedIn(double time) {
    return path.speed(time) / scale;
  }

  /** Returns the way at its begin, in m. */
  double begin() {
    return path.way(inPath(now));
  }

  /** Returns the speed at its begin, in m/s. */
  double firstSpeed() {
    return speedIn(inPath(now));
  }
}

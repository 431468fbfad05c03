package dev.eventchain.simulation.world;

/** States of a trace for tests in which the position of the ego does not matter. */
public final class States {

  private States() {}

  public static Trace.State of(
      long time, double speed, double gap, double timeToCollision, double deceleration) {
    return new Trace.State(
        time, speed, gap, timeToCollision, deceleration, 0, Double.NaN, Trace.Pose.STRAIGHT);
  }
}

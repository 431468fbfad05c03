package dev.eventchain.simulation;

/** States of a trace for tests in which it does not matter where the ego is. */
final class States {

  private States() {}

  static Trace.State of(
      long time, double speed, double gap, double timeToCollision, double deceleration) {
    return new Trace.State(
        time, speed, gap, timeToCollision, deceleration, 0, Double.NaN, Trace.Pose.STRAIGHT);
  }
}

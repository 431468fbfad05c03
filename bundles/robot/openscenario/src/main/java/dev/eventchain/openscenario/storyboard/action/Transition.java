package dev.eventchain.openscenario.storyboard.action;

/**
 * A value that changes over time and then stays.
 *
 * @param duration in s, greater than 0
 */
record Transition(Shape shape, double from, double to, double duration) {

  double value(double time) {
    return from + (to - from) * shape.value(part(time));
  }

  double rate(double time) {
    return time >= duration ? 0 : (to - from) * shape.slope(part(time)) / duration;
  }

  /** Returns the integral from time 0. */
  double integral(double time) {
    double within = Math.min(time, duration);
    return from * within
        + (to - from) * duration * shape.integral(part(time))
        + to * (time - within);
  }

  private double part(double time) {
    return Math.min(1, time / duration);
  }
}

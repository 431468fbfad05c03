package dev.eventchain.openscenario.storyboard.world;

/** Angles in rad. */
public final class Angles {

  private Angles() {}

  /** Returns the same direction from -pi to pi. */
  public static double normalized(double angle) {
    return Math.abs(angle) <= Math.PI ? angle : Math.IEEEremainder(angle, 2 * Math.PI);
  }

  /** Returns the angle between two directions, from 0 to pi. */
  public static double between(double first, double second) {
    return Math.abs(normalized(first - second));
  }
}

package dev.eventchain.openscenario.storyboard.world;

/**
 * The bounding box of an entity, in m.
 *
 * @param x its centre ahead of the reference point
 * @param y its centre to the left of the reference point
 * @param z its centre above the reference point
 */
public record Box(double x, double y, double z, double length, double width, double height) {

  /** Returns how far the front is ahead of the reference point. */
  public double front() {
    return x + length / 2;
  }

  /** Returns how far the rear is ahead of the reference point; mostly negative. */
  public double rear() {
    return x - length / 2;
  }
}

package dev.eventchain.simulation.world;

/**
 * Size of a vehicle's body, a box.
 *
 * @param length in m
 * @param width in m
 * @param height above the road, in m: it passes under higher objects
 * @param frontOverhang from the front axle to the bumper, in m
 */
public record Shape(double length, double width, double height, double frontOverhang) {

  /** A passenger car of the compact class; assumed, without a source. */
  public static final Shape USUAL = new Shape(4.5, 1.8, 1.5, 0.9);

  /** Returns the body of a vehicle whose front bumper has its middle at a place. */
  public Body body(Road.Place front) {
    return new Body(front.ahead(-length / 2), length, width, 0.0, height, 0.0f);
  }
}

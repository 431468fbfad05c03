package dev.eventchain.simulation.sensor;

import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Shape;
import java.util.OptionalDouble;

/**
 * Place and direction of a sensor on the vehicle. Without a place of its own, it is in the middle
 * of the side that it looks away from: of the front, the rear, or the left or right side.
 *
 * @param ahead of the front bumper, in m; negative behind it
 * @param left of the vehicle's axis, in m
 * @param direction of the middle of its view, in rad to the left of the vehicle's own
 */
public record Mounting(OptionalDouble ahead, OptionalDouble left, double direction) {

  /** In the middle of the front bumper, looking ahead. */
  public static final Mounting FRONT =
      new Mounting(OptionalDouble.empty(), OptionalDouble.empty(), 0.0);

  /**
   * Returns where the sensor is, and in which direction it looks.
   *
   * @param front the middle of the front bumper, and the vehicle's heading
   */
  Road.Place place(Road.Place front, Shape shape) {
    double sideways = StrictMath.sin(direction);
    double forward = StrictMath.cos(direction);
    boolean aside = Math.abs(sideways) > Math.abs(forward);
    double usualAhead = aside ? -shape.length() / 2 : forward < 0.0 ? -shape.length() : 0.0;
    double usualLeft = aside ? Math.copySign(shape.width() / 2, sideways) : 0.0;
    double x = ahead.orElse(usualAhead);
    double y = left.orElse(usualLeft);
    if (x == 0.0 && y == 0.0 && direction == 0.0) {
      return front; // exactly, whatever the heading
    }
    double cos = StrictMath.cos(front.heading());
    double sin = StrictMath.sin(front.heading());
    return new Road.Place(
        front.x() + x * cos - y * sin, front.y() + x * sin + y * cos, front.heading() + direction);
  }
}

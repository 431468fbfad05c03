package dev.eventchain.simulation.sensor;

import dev.eventchain.simulation.sensor.ObjectSensor.Property;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.World;

/**
 * An object in the frame of a sensor, in coherent units.
 *
 * @param distance in the sensor's direction to its nearest point; negative behind, 0 beside
 * @param x of its middle, in the sensor's direction
 * @param y of its middle, to the left
 * @param range to its nearest point
 * @param speed over ground, in the sensor's direction
 * @param across its speed over ground to the left of the sensor's direction
 * @param egoAlong the speed of the vehicle in the sensor's direction
 * @param egoAcross the speed of the vehicle to the left of the sensor's direction
 * @param heading of its front, to the left of the sensor's direction, -pi to pi
 */
record SeenObject(
    Actor actor,
    double id,
    double distance,
    double x,
    double y,
    double range,
    double speed,
    double across,
    double egoAlong,
    double egoAcross,
    double heading) {

  /** Nearer than this, the direction of an object's end is that of one so far away, in m. */
  private static final double NEAREST = 0.1;

  /**
   * Returns an object as seen from a place.
   *
   * @param direction of the sensor, in rad to the left of the vehicle's own
   */
  static SeenObject of(World world, Actor actor, Road.Place eye, double direction, int id) {
    double seconds = World.seconds(world.now());
    Body body = actor.body(world.road(), seconds);
    double cos = StrictMath.cos(eye.heading());
    double sin = StrictMath.sin(eye.heading());
    double dx = body.place().x() - eye.x();
    double dy = body.place().y() - eye.y();
    double x = dx * cos + dy * sin;
    double turned = world.road().heading(actor.along(seconds)) - eye.heading();
    double along = actor.speedAlong(seconds);
    double across = actor.speedAcross(seconds);
    return new SeenObject(
        actor,
        id,
        distance(x, body.extent(eye.heading() - body.place().heading())),
        x,
        dy * cos - dx * sin,
        nearest(body, eye),
        along * StrictMath.cos(turned) - across * StrictMath.sin(turned),
        along * StrictMath.sin(turned) + across * StrictMath.cos(turned),
        world.ego().velocity() * StrictMath.cos(direction),
        -world.ego().velocity() * StrictMath.sin(direction),
        StrictMath.IEEEremainder(body.place().heading() - eye.heading(), 2 * Math.PI));
  }

  private static double distance(double middle, double extent) {
    if (middle > extent) {
      return middle - extent;
    }
    return middle < -extent ? middle + extent : 0.0;
  }

  /** Returns the distance from a place to the nearest point of a box, in m; 0 inside. */
  private static double nearest(Body body, Road.Place eye) {
    double cos = StrictMath.cos(body.place().heading());
    double sin = StrictMath.sin(body.place().heading());
    double dx = eye.x() - body.place().x();
    double dy = eye.y() - body.place().y();
    double ahead = Math.max(0.0, Math.abs(dx * cos + dy * sin) - body.length() / 2);
    double aside = Math.max(0.0, Math.abs(dy * cos - dx * sin) - body.width() / 2);
    return StrictMath.hypot(ahead, aside);
  }

  /** Returns the direction of its middle, in rad to the left of the sensor's. */
  double azimuth() {
    return StrictMath.atan2(y, x);
  }

  /** Returns the direction of the middle of its near end, in rad to the left of the sensor's. */
  double azimuthOfEnd() {
    return StrictMath.atan2(y, Math.max(distance, NEAREST));
  }

  private double rangeRate() {
    double distance = StrictMath.hypot(x, y);
    double closing = (speed - egoAlong) * x + (across - egoAcross) * y;
    return distance > 0.0 ? closing / distance : 0.0;
  }

  /** Returns the value of a number; a class has none. */
  double value(Property property) {
    return switch (property) {
      case ID -> id;
      case DISTANCE -> distance;
      case LATERAL, Y -> y;
      case RELATIVE_SPEED -> speed - egoAlong;
      case SPEED -> speed;
      case LATERAL_SPEED -> across;
      case X -> x;
      case RANGE -> range;
      case AZIMUTH -> azimuth();
      case RANGE_RATE -> rangeRate();
      case HEADING -> heading;
      case ORIENTATION_Z -> StrictMath.sin(heading / 2);
      case ORIENTATION_W -> StrictMath.cos(heading / 2);
      case LENGTH -> actor.size().length();
      case WIDTH -> actor.size().width();
      case HEIGHT -> actor.size().top();
      case CLASS -> throw new IllegalArgumentException(property.id());
    };
  }
}

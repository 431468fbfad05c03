package dev.eventchain.simulation.world;

/**
 * A contact of the ego with another actor.
 *
 * @param time in ns
 * @param other the other actor
 * @param speed of one relative to the other, in m/s
 * @param side the touched side of the ego
 * @param driven true if the ego moves towards the other one
 */
public record Contact(long time, Actor other, double speed, Side side, boolean driven) {

  /** A side of the ego. */
  enum Side {
    FRONT("front"),
    LEFT("left side"),
    RIGHT("right side"),
    REAR("rear");

    private final String words;

    Side(String words) {
      this.words = words;
    }

    String words() {
      return words;
    }
  }

  /** Returns whether another actor drove into the ego's rear, which is not an impact of the ego. */
  boolean fromBehind() {
    return side == Side.REAR && !driven;
  }

  /** Returns the parties of the contact, in words. */
  public String words() {
    return driven
        ? "the ego's " + side.words() + " hit " + other.name()
        : other.name() + " hit the ego's " + side.words();
  }

  /**
   * Classifies a contact.
   *
   * @param motion the ego at the contact
   */
  static Contact of(long time, EgoMotion motion, Actor other, Road road) {
    Road.Place ego = motion.front();
    double velocity = motion.velocity();
    double seconds = World.seconds(time);
    Body body = other.body(road, seconds);
    double direction = road.heading(other.along(seconds));
    double cos = StrictMath.cos(direction - ego.heading());
    double sin = StrictMath.sin(direction - ego.heading());
    double along = other.speedAlong(seconds) * cos - other.speedAcross(seconds) * sin;
    double across = other.speedAlong(seconds) * sin + other.speedAcross(seconds) * cos;
    Side side = side(ego, motion.shape(), body);
    boolean driven =
        switch (side) {
          case FRONT -> velocity > 0.0;
          case REAR -> velocity < 0.0;
          case LEFT -> -other.speedAcross(seconds) < TOWARDS && velocity != 0.0;
          case RIGHT -> other.speedAcross(seconds) < TOWARDS && velocity != 0.0;
        };
    return new Contact(time, other, StrictMath.hypot(velocity - along, across), side, driven);
  }

  /** Speed across the road, in m/s, below which an actor does not drive into the ego's side. */
  private static final double TOWARDS = 0.05;

  /** Returns the side along whose normal the boxes are farthest apart, or overlap least. */
  private static Side side(Road.Place front, Shape ego, Body other) {
    Road.Place middle = front.ahead(-ego.length() / 2);
    double cos = StrictMath.cos(front.heading());
    double sin = StrictMath.sin(front.heading());
    double x = other.place().x() - middle.x();
    double y = other.place().y() - middle.y();
    double ahead = x * cos + y * sin;
    double left = y * cos - x * sin;
    double turned = front.heading() - other.place().heading();
    double lengthwise = Math.abs(ahead) - ego.length() / 2 - other.extent(turned);
    double sideways = Math.abs(left) - ego.width() / 2 - other.extent(turned - Math.PI / 2);
    if (lengthwise >= sideways) {
      return ahead > 0.0 ? Side.FRONT : Side.REAR;
    }
    return left > 0.0 ? Side.LEFT : Side.RIGHT;
  }
}

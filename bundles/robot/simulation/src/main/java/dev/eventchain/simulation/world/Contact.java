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
    boolean turns = motion.spin() != 0.0;
    boolean moves = velocity != 0.0 || turns;
    boolean driven =
        switch (side) {
          case FRONT -> velocity > 0.0 || (turns && -along < TOWARDS);
          case REAR -> velocity < 0.0 || (turns && along < TOWARDS);
          case LEFT -> -other.speedAcross(seconds) < TOWARDS && moves;
          case RIGHT -> other.speedAcross(seconds) < TOWARDS && moves;
        };
    Point point = point(motion, body);
    double forwards = velocity - motion.spin() * point.left() - along;
    double sideways = motion.spin() * point.ahead() - across;
    return new Contact(time, other, StrictMath.hypot(forwards, sideways), side, driven);
  }

  /** Speed in m/s below which an actor does not drive into the ego. */
  private static final double TOWARDS = 0.05;

  /** A point of the ego, in m from its rear axle. */
  private record Point(double ahead, double left) {}

  /** Returns the point of the ego that is nearest to the middle of another body. */
  private static Point point(EgoMotion motion, Body other) {
    Road.Place axle = motion.front().ahead(-motion.axleToBumper());
    double cos = StrictMath.cos(axle.heading());
    double sin = StrictMath.sin(axle.heading());
    double x = other.place().x() - axle.x();
    double y = other.place().y() - axle.y();
    double front = motion.axleToBumper();
    double side = motion.shape().width() / 2;
    double ahead = Math.max(front - motion.shape().length(), Math.min(front, x * cos + y * sin));
    return new Point(ahead, Math.max(-side, Math.min(side, y * cos - x * sin)));
  }

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

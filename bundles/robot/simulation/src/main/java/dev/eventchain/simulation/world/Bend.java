package dev.eventchain.simulation.world;

/**
 * A road of constant curvature, with a wall and posts on both sides.
 *
 * @param curvature in 1/m, to the left is positive, 0 if it is straight
 * @param laneWidth between the lines of each lane, in m
 */
record Bend(double curvature, double laneWidth) implements Road {

  @Override
  public Place place(double along, double across) {
    if (curvature == 0.0) {
      return new Place(along, across, 0.0);
    }
    double radius = 1.0 / curvature;
    double turned = along * curvature;
    return new Place(
        (radius - across) * StrictMath.sin(turned),
        radius - (radius - across) * StrictMath.cos(turned),
        turned);
  }

  @Override
  public Station station(double x, double y, double near) {
    if (curvature == 0.0) {
      return new Station(x, y);
    }
    double radius = 1.0 / Math.abs(curvature);
    double side = Math.signum(curvature);
    double toCentre = radius - side * y;
    double along = StrictMath.atan2(x, toCentre) * radius;
    double circle = 2.0 * Math.PI * radius;
    along += Math.rint((near - along) / circle) * circle;
    return new Station(along, side * (radius - StrictMath.hypot(x, toCentre)));
  }

  @Override
  public boolean isStraight() {
    return curvature == 0.0;
  }

  @Override
  public boolean isFurnished() {
    return true;
  }

  @Override
  public double curvature(double along) {
    return curvature;
  }

  @Override
  public double laneWidth(double along) {
    return laneWidth;
  }

  @Override
  public double heading(double along) {
    return along * curvature;
  }

  @Override
  public double wall(Place from, double dx, double dy) {
    if (curvature == 0.0) {
      return (Math.copySign(WALL_DISTANCE, dy) - from.y()) / dy;
    }
    double radius = 1.0 / Math.abs(curvature);
    double y = from.y() - 1.0 / curvature;
    double inner = circle(from.x(), y, dx, dy, radius - WALL_DISTANCE, false);
    return Math.min(inner, circle(from.x(), y, dx, dy, radius + WALL_DISTANCE, true));
  }

  /** Returns the distance at which a ray enters a circle around the origin, or leaves it. */
  private static double circle(
      double x, double y, double dx, double dy, double radius, boolean leaves) {
    double flat = dx * dx + dy * dy;
    double half = (x * dx + y * dy) / flat;
    double root = half * half - (x * x + y * y - radius * radius) / flat;
    if (root < 0.0) {
      return Double.POSITIVE_INFINITY;
    }
    double at = leaves ? -half + Math.sqrt(root) : -half - Math.sqrt(root);
    return at > 0.0 ? at : Double.POSITIVE_INFINITY;
  }
}

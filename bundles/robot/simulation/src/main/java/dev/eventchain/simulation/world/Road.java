package dev.eventchain.simulation.world;

/**
 * A road with lanes parallel to the centre line of the ego's lane. It starts at the ego's front
 * bumper and is straight or has a constant curvature.
 *
 * @param curvature in 1/m, to the left is positive, 0 if it is straight
 * @param laneWidth between the lines of each lane, in m
 */
public record Road(double curvature, double laneWidth) {

  /** The usual width of a lane of a motorway (German RAA 2008, cross-section RQ 31: 3.75 m). */
  public static final double USUAL_LANE_WIDTH = 3.75;

  /** A straight road. */
  public static final Road STRAIGHT = new Road(0.0, USUAL_LANE_WIDTH);

  /**
   * Distance from the centre line of the ego's lane to the walls on both sides of the road, in m.
   */
  public static final double WALL_DISTANCE = 8.0;

  /** A place and a direction in the plane, in m and rad; at the start x is along the road. */
  public record Place(double x, double y, double heading) {

    /** Returns the place ahead of this one by a distance in m. */
    public Place ahead(double distance) {
      return new Place(
          x + distance * StrictMath.cos(heading), y + distance * StrictMath.sin(heading), heading);
    }
  }

  /** A place in road coordinates: along its centre line, and left of it, in m. */
  public record Station(double along, double across) {}

  /** Returns the place of a station, in the direction of the road. */
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

  /**
   * Returns the station of a place.
   *
   * @param near approximate distance along the road, since a circle returns to its start
   */
  Station station(double x, double y, double near) {
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

  /**
   * Returns the distance to the left line of the ego's lane from an offset left of its centre line,
   * in m.
   */
  public double toTheLeft(double offset) {
    return laneWidth / 2 - offset;
  }

  /** Returns the distance to the right line likewise. */
  public double toTheRight(double offset) {
    return laneWidth / 2 + offset;
  }

  /** Returns the direction of the road at a distance along it, in rad. */
  public double heading(double along) {
    return along * curvature;
  }

  /**
   * Returns the distance at which a ray meets the nearest wall, in m; infinite if it never does.
   *
   * @param from a place between the walls
   * @param dx direction of the ray in the plane, with the length of its projection
   */
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

package dev.eventchain.roads.road;

import dev.eventchain.roads.geometry.Profile;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** A lane of a lane section. Its places are those of the road. Immutable. */
public final class Lane {

  /** Types on which vehicles drive along. */
  private static final Set<String> DRIVABLE =
      Set.of(
          "driving",
          "bidirectional",
          "entry",
          "exit",
          "onRamp",
          "offRamp",
          "connectingRamp",
          "slipLane",
          "bus",
          "taxi",
          "HOV",
          "mwyEntry",
          "mwyExit",
          "special1",
          "special2",
          "special3",
          "shared");

  /** The directions of traffic on a lane, compared with what the road's rule says. */
  public enum Direction {
    STANDARD,
    REVERSED,
    BOTH
  }

  /**
   * The shape of a lane.
   *
   * @param width in m; unused where there is a border
   * @param border t of the outer edge, from lane 0, in m
   * @param innerHeight above the road at the inner edge, in m
   * @param outerHeight above the road at the outer edge, in m
   */
  public record Shape(
      Profile width, Optional<Profile> border, Profile innerHeight, Profile outerHeight) {}

  private final int id;
  private final String type;
  private final boolean level;
  private final Direction direction;
  private final Shape shape;
  private final List<RoadMark> marks;
  private final List<Road.SpeedLimit> limits;

  /** Creates a lane of the parts that were read. */
  public Lane(
      int id,
      String type,
      boolean level,
      Direction direction,
      Shape shape,
      List<RoadMark> marks,
      List<Road.SpeedLimit> limits) {
    this.id = id;
    this.type = type;
    this.level = level;
    this.direction = direction;
    this.shape = shape;
    this.marks = List.copyOf(marks);
    this.limits = List.copyOf(limits);
  }

  /** Returns the id: positive left of the reference line, negative right of it, 0 between. */
  public int id() {
    return id;
  }

  /** Returns the type as in OpenDRIVE, such as {@code driving}. */
  public String type() {
    return type;
  }

  /** Returns whether vehicles drive along it. */
  public boolean isDrivable() {
    return DRIVABLE.contains(type);
  }

  /** Returns whether it stays level where the road is tilted sideways. */
  public boolean isLevel() {
    return level;
  }

  /** Returns the directions of traffic. */
  public Direction direction() {
    return direction;
  }

  /** Returns the markings of its outer edge, in the order of s; of lane 0, those between. */
  public List<RoadMark> marks() {
    return marks;
  }

  /** Returns the speed limits of its own, in the order of s. */
  public List<Road.SpeedLimit> limits() {
    return limits;
  }

  boolean hasHeight() {
    return !shape.innerHeight.isZero() || !shape.outerHeight.isZero();
  }

  /** Returns the height above the road, in m, at a share of the way from inner to outer edge. */
  double height(double s, double share) {
    double inner = shape.innerHeight.at(s);
    return inner + share * (shape.outerHeight.at(s) - inner);
  }

  /**
   * Returns t of the outer edge from lane 0, or a derivative.
   *
   * @param inner the same of the inner edge
   */
  double outerEdge(double inner, double s, int order) {
    if (shape.border.isPresent()) {
      return shape.border.get().at(s, order);
    }
    boolean vanished = shape.width.at(s) <= 0;
    return inner + (vanished ? 0 : Math.signum(id) * shape.width.at(s, order));
  }

  /** Returns the width, or the distance of the border to lane 0, as the file has it, in m. */
  public double statedWidth(double s) {
    return shape.border.isPresent()
        ? Math.signum(id) * shape.border.get().at(s)
        : shape.width.at(s);
  }

  /** Returns where its polynomials begin. */
  public double[] breaks() {
    return shape.border.orElse(shape.width).starts();
  }
}

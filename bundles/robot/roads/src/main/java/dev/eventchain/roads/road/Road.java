package dev.eventchain.roads.road;

import dev.eventchain.roads.geometry.PlanPoint;
import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.geometry.ReferenceLine;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;

/**
 * A road: a reference line, and lanes on both sides. Places beyond its ends are those of the nearer
 * end, continued straight. Immutable.
 */
public final class Road {

  /**
   * A speed limit from a place on.
   *
   * @param start s where it begins, in m
   * @param limit in m/s; empty for no limit, and where the file leaves it undefined
   */
  public record SpeedLimit(double start, OptionalDouble limit) {}

  /** The side on which vehicles drive. */
  public enum Traffic {
    /** On the right: lanes with negative ids lead along s. */
    RIGHT_HAND,
    /** On the left: lanes with positive ids lead along s. */
    LEFT_HAND
  }

  /**
   * Properties of a road apart from its geometry.
   *
   * @param types the types of the road, in the order of s
   * @param userData what the program that made the file says of the road, by its codes
   */
  public record Facts(
      String id,
      Traffic traffic,
      List<RoadType> types,
      Optional<RoadLink> predecessor,
      Optional<RoadLink> successor,
      Map<String, String> userData) {}

  /**
   * The type of a road from a place on.
   *
   * @param start s where it begins, in m
   * @param type as in OpenDRIVE, such as {@code motorway}
   * @param limit the speed limit; empty if the file has none
   */
  public record RoadType(double start, String type, Optional<SpeedLimit> limit) {}

  /** Objects and signals beside and on a road. */
  public record Furniture(
      List<RoadObject> objects, List<Signal> signals, List<Signal.Reference> references) {

    /** Nothing beside or on a road. */
    public static final Furniture NONE = new Furniture(List.of(), List.of(), List.of());

    /** Copies the lists. */
    public Furniture {
      objects = List.copyOf(objects);
      signals = List.copyOf(signals);
      references = List.copyOf(references);
    }
  }

  private final Facts facts;
  private final ReferenceLine line;
  private final RoadSurface surface;
  private final Profile laneOffset;
  private final List<LaneSection> sections;
  private final double[] sectionStarts;
  private final Furniture furniture;
  private final boolean raised;

  /** Creates a road of the parts that were read. */
  public Road(
      Facts facts,
      ReferenceLine line,
      RoadSurface surface,
      Profile laneOffset,
      List<LaneSection> sections,
      Furniture furniture) {
    this.facts = facts;
    this.line = line;
    this.surface = surface;
    this.laneOffset = laneOffset;
    this.sections = List.copyOf(sections);
    this.sectionStarts = sections.stream().mapToDouble(LaneSection::start).toArray();
    this.furniture = furniture;
    this.raised =
        sections.stream().flatMap(section -> section.lanes().stream()).anyMatch(Lane::hasHeight);
  }

  /** Returns the id. */
  public String id() {
    return facts.id;
  }

  /** Returns the value of a {@code userData} of the road; empty if it has none of this code. */
  public Optional<String> userData(String code) {
    return Optional.ofNullable(facts.userData.get(code));
  }

  /** Returns the length of the reference line, in m. */
  public double length() {
    return line.length();
  }

  /** Returns the side on which vehicles drive. */
  public Traffic traffic() {
    return facts.traffic;
  }

  /** Returns what is before the start. */
  public Optional<RoadLink> predecessor() {
    return facts.predecessor;
  }

  /** Returns what is behind the end. */
  public Optional<RoadLink> successor() {
    return facts.successor;
  }

  /** Returns the lane sections in the order of s; at least one. */
  public List<LaneSection> sections() {
    return sections;
  }

  /** Returns the lane section at a place; from where the next one begins on, it is that one. */
  public LaneSection section(double s) {
    return sections.get(sectionIndex(s));
  }

  /** Returns the same road with a further lane section, which begins at a place. */
  public Road divided(double s) {
    List<LaneSection> all = new ArrayList<>();
    for (LaneSection each : sections) {
      boolean inside = s > each.start() + Profile.ROUNDING && s < each.end() - Profile.ROUNDING;
      all.addAll(inside ? each.divided(s) : List.of(each));
    }
    return new Road(facts, line, surface, laneOffset, all, furniture);
  }

  /** Returns the index of the lane section at a place. */
  public int sectionIndex(double s) {
    return Math.max(0, Profile.indexAt(sectionStarts, s));
  }

  /** Returns the objects beside and on the road, in the order of the file. */
  public List<RoadObject> objects() {
    return furniture.objects;
  }

  /** Returns the signals of the road, in the order of the file. */
  public List<Signal> signals() {
    return furniture.signals;
  }

  /** Returns the signals of other roads that also apply to this one, in the order of the file. */
  public List<Signal.Reference> signalReferences() {
    return furniture.references;
  }

  /** Returns the ids of the lanes at a place from left to right, without 0. */
  public List<Integer> laneIds(double s) {
    return section(s).lanes().stream().map(Lane::id).filter(id -> id != 0).toList();
  }

  /** Returns a lane at a place. */
  public Optional<Lane> lane(double s, int id) {
    return section(s).lane(id);
  }

  /** Returns the lane at a place; empty beside all lanes. */
  public OptionalInt laneAt(double s, double t) {
    return section(s).laneAt(s, t);
  }

  /** Returns the curvature of the reference line, in 1/m, positive to the left. */
  public double curvature(double s) {
    return line.curvature(s);
  }

  /** Returns the heading of the reference line, in rad. */
  public double heading(double s) {
    return line.at(s).heading();
  }

  /** Returns whether vehicles on a lane may drive along s, or else against it. */
  public boolean leads(Lane lane, boolean alongS) {
    boolean standard = (lane.id() < 0) == (traffic() == Traffic.RIGHT_HAND);
    return switch (lane.direction()) {
      case STANDARD -> standard == alongS;
      case REVERSED -> standard != alongS;
      case BOTH -> true;
    };
  }

  /**
   * Returns the speed limit of a lane, in m/s: that of the lane, or else of the road. Empty for no
   * limit, and if the file does not say.
   *
   * @throws IllegalArgumentException if there is no such lane
   */
  public OptionalDouble speedLimit(double s, int laneId) {
    Lane lane = lane(s, laneId).orElseThrow(() -> new IllegalArgumentException("no such lane"));
    SpeedLimit own = null;
    for (SpeedLimit limit : lane.limits()) {
      own = limit.start() <= s ? limit : own;
    }
    return own == null ? speedLimit(s) : own.limit();
  }

  /** Returns the speed limit of the road, in m/s; empty for none, and if the file does not say. */
  public OptionalDouble speedLimit(double s) {
    Optional<SpeedLimit> limit = type(s).flatMap(RoadType::limit);
    return limit.isPresent() ? limit.get().limit() : OptionalDouble.empty();
  }

  /** Returns the type of the road at a place; empty if the file does not say. */
  public Optional<RoadType> type(double s) {
    RoadType found = null;
    for (RoadType type : facts.types) {
      found = type.start <= s ? type : found;
    }
    return Optional.ofNullable(found);
  }

  /** Returns the pose of a point of the surface, in the direction of s. */
  public Pose pose(double s, double t) {
    return pose(s, t, 0);
  }

  /** Returns the pose of a point above the surface, in the direction of s. */
  public Pose pose(double s, double t, double height) {
    double inside = inside(s);
    LaneSection section = section(inside);
    double level = surface.isPlane() ? Double.POSITIVE_INFINITY : section.level(t > 0, inside);
    return surface.pose(
        line.at(s), inside, t, level, height + (raised ? kerb(section, inside, t) : 0));
  }

  /** Returns the height of a lane above the road, in m. */
  private static double kerb(LaneSection section, double s, double t) {
    for (Lane lane : section.lanes()) {
      if (lane.hasHeight()) {
        double inner = section.innerEdge(lane.id(), s);
        double share = (t - inner) / (section.outerEdge(lane.id(), s) - inner);
        if (share >= 0 && share <= 1) {
          return lane.height(s, share);
        }
      }
    }
    return 0;
  }

  /** Returns whether its surface is at z = 0 everywhere. */
  public boolean isFlat() {
    return surface.isPlane() && !raised;
  }

  /** Returns s of the nearest place on the road. */
  public double inside(double s) {
    return Math.max(0, Math.min(length(), s));
  }

  /** Returns the point of the reference line. */
  public PlanPoint plan(double s) {
    return line.at(s);
  }

  /** Returns the reference line. */
  public ReferenceLine line() {
    return line;
  }

  /** Returns t of lane 0. */
  public Profile laneOffset() {
    return laneOffset;
  }

  /**
   * Returns s and t of the point of a part of the road that is nearest to a place. The part must
   * not turn by more than a right angle.
   */
  public double[] project(double x, double y, double from, double to) {
    double[] plan = projectPlan(x, y, from, to);
    double s = plan[0];
    double t = plan[1];
    // Where the surface is tilted, points are not above those of the plan view.
    for (int i = 0; !surface.isPlane() && i < 20; i++) {
      Pose pose = pose(s, t);
      double dx = x - pose.x();
      double dy = y - pose.y();
      if (StrictMath.hypot(dx, dy) < 1e-7) {
        break;
      }
      PlanPoint near = line.at(s);
      double ahead = dx * StrictMath.cos(near.heading()) + dy * StrictMath.sin(near.heading());
      double squeezed = Math.max(0.1, 1 - near.curvature() * t);
      s = Math.max(from, Math.min(to, s + ahead / squeezed));
      double across = dy * StrictMath.cos(near.heading()) - dx * StrictMath.sin(near.heading());
      t += across / Math.max(0.1, StrictMath.cos(pose.roll()));
    }
    return new double[] {s, t};
  }

  /** As {@link #project}, as if the surface was not tilted. */
  public double[] projectPlan(double x, double y, double from, double to) {
    double s = line.nearest(x, y, from, to);
    return new double[] {s, offset(line.at(s), x, y)};
  }

  private static double offset(PlanPoint point, double x, double y) {
    double dx = x - point.x();
    double dy = y - point.y();
    return dy * StrictMath.cos(point.heading()) - dx * StrictMath.sin(point.heading());
  }
}

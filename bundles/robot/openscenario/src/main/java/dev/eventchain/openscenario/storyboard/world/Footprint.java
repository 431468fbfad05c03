package dev.eventchain.openscenario.storyboard.world;

import java.util.List;
import java.util.stream.DoubleStream;

/** The rectangle that an entity covers on the ground. */
public final class Footprint {

  private final List<Pose> corners;

  private Footprint(List<Pose> corners) {
    this.corners = corners;
  }

  /** Returns that of a box whose reference point is at a pose. */
  public static Footprint of(Pose pose, Box box) {
    double left = box.y() + box.width() / 2;
    double right = box.y() - box.width() / 2;
    return new Footprint(
        List.of(
            pose.moved(box.front(), left),
            pose.moved(box.rear(), left),
            pose.moved(box.rear(), right),
            pose.moved(box.front(), right)));
  }

  /** Returns that of a point. */
  public static Footprint of(Pose pose) {
    return new Footprint(List.of(pose));
  }

  /** Returns how far the corners are ahead of a pose. */
  public DoubleStream ahead(Pose of) {
    return corners.stream().mapToDouble(of::ahead);
  }

  /** Returns how far the corners are to the left of a pose. */
  public DoubleStream left(Pose of) {
    return corners.stream().mapToDouble(of::left);
  }

  /** Returns the corners, anticlockwise from the one at the front on the left. */
  public List<Pose> corners() {
    return corners;
  }

  /** Returns whether two rectangles share a point. */
  public boolean touches(Footprint other) {
    return !isBeside(this, other) && !isBeside(other, this);
  }

  /** Returns whether an edge of the first separates the two. */
  private static boolean isBeside(Footprint first, Footprint second) {
    int count = first.corners.size();
    for (int i = 0; i < count; i++) {
      Pose from = first.corners.get(i);
      Pose to = first.corners.get((i + 1) % count);
      Pose edge = from.withHeading(StrictMath.atan2(to.y() - from.y(), to.x() - from.x()));
      // Anticlockwise, so that the inside is to the left.
      if (second.left(edge).allMatch(each -> each < 0)) {
        return true;
      }
    }
    return false;
  }

  /** Returns the distance on the ground; 0 if they touch. */
  public double distance(Footprint other) {
    if (corners.size() > 1 && other.corners.size() > 1 && touches(other)) {
      return 0;
    }
    return Math.min(nearest(this, other), nearest(other, this));
  }

  /** Returns the shortest way from a corner of the first to an edge of the second. */
  private static double nearest(Footprint first, Footprint second) {
    double shortest = Double.POSITIVE_INFINITY;
    int count = second.corners.size();
    for (Pose corner : first.corners) {
      for (int i = 0; i < count; i++) {
        Pose from = second.corners.get(i);
        Pose to = second.corners.get((i + 1) % count);
        shortest = Math.min(shortest, toEdge(corner, from, to));
      }
    }
    return shortest;
  }

  private static double toEdge(Pose point, Pose from, Pose to) {
    double length = StrictMath.hypot(to.x() - from.x(), to.y() - from.y());
    Pose edge = from.withHeading(StrictMath.atan2(to.y() - from.y(), to.x() - from.x()));
    double along = Math.max(0, Math.min(length, edge.ahead(point)));
    return StrictMath.hypot(edge.ahead(point) - along, edge.left(point));
  }
}

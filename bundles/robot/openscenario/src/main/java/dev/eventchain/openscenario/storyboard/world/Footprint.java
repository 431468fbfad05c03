package dev.eventchain.openscenario.storyboard.world;

import dev.eventchain.roads.ground.Rectangle;
import java.util.List;
import java.util.stream.DoubleStream;

/** The rectangle that an entity covers on the ground. */
public final class Footprint {

  private final Rectangle covered;
  private final List<Pose> corners;

  private Footprint(Rectangle covered, List<Pose> corners) {
    this.covered = covered;
    this.corners = corners;
  }

  /** Returns that of a box whose reference point is at a pose. */
  public static Footprint of(Pose pose, Box box) {
    double left = box.y() + box.width() / 2;
    double right = box.y() - box.width() / 2;
    return new Footprint(
        rectangle(pose.moved(box.x(), box.y()), box.length(), box.width()),
        List.of(
            pose.moved(box.front(), left),
            pose.moved(box.rear(), left),
            pose.moved(box.rear(), right),
            pose.moved(box.front(), right)));
  }

  /** Returns that of a point. */
  public static Footprint of(Pose pose) {
    return new Footprint(rectangle(pose, 0, 0), List.of(pose));
  }

  private static Rectangle rectangle(Pose middle, double length, double width) {
    return new Rectangle(middle.x(), middle.y(), middle.heading(), length, width);
  }

  /** Returns how far the corners are ahead of a pose. */
  public DoubleStream ahead(Pose of) {
    return corners.stream().mapToDouble(of::ahead);
  }

  /** Returns how far the corners are to the left of a pose. */
  public DoubleStream left(Pose of) {
    return corners.stream().mapToDouble(of::left);
  }

  /** Returns whether two of them share a point. */
  public boolean touches(Footprint other) {
    return covered.touches(other.covered);
  }

  /** Returns the distance on the ground; 0 if they touch. */
  public double distance(Footprint other) {
    return covered.distance(other.covered);
  }
}

package dev.eventchain.simulation;

import java.util.ArrayList;
import java.util.List;

/** What the lidar can see besides the road and the walls: vehicles, and posts beside the road. */
final class RoadScene {

  /** From the centre line of the ego's lane to the walls on both sides of the road, in m. */
  static final double WALL_DISTANCE = 8.0;

  /** Height of the walls, in m. */
  static final double WALL_HEIGHT = 2.0;

  private static final double POST_DISTANCE = 6.0;
  private static final double POST_SPACING = 25.0;
  private static final double POST_WIDTH = 0.3;
  private static final double POST_HEIGHT = 3.0;
  private static final double VIEW = 110.0;
  private static final float VEHICLE_INTENSITY = 0.8f;
  private static final float POST_INTENSITY = 0.5f;

  private RoadScene() {}

  /** The solids ahead of the ego at this moment. */
  static List<Box> boxes(World world) {
    List<Box> boxes = new ArrayList<>();
    for (TargetVehicle target : world.targets()) {
      double rear = world.distanceTo(target);
      if (rear < VIEW && rear + target.length() > 0.0) {
        boxes.add(
            new Box(
                rear,
                rear + target.length(),
                target.lateralOffset() - target.width() / 2,
                target.lateralOffset() + target.width() / 2,
                target.height(),
                VEHICLE_INTENSITY));
      }
    }
    double first = POST_SPACING - world.ego().position() % POST_SPACING;
    for (double rear = first; rear < VIEW; rear += POST_SPACING) {
      boxes.add(post(rear, POST_DISTANCE));
      boxes.add(post(rear, -POST_DISTANCE));
    }
    return boxes;
  }

  private static Box post(double rear, double y) {
    return new Box(
        rear,
        rear + POST_WIDTH,
        y - POST_WIDTH / 2,
        y + POST_WIDTH / 2,
        POST_HEIGHT,
        POST_INTENSITY);
  }
}

package dev.eventchain.simulation.sensor;

import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.List;

/**
 * Bodies visible to a sensor besides the road and the walls: all on the road, and posts next to it.
 *
 * @param ego the position of the ego's front bumper, and its heading
 */
public record RoadScene(Road road, Road.Place ego, List<Body> bodies) {

  /** Distance of the posts from the centre line of the ego's lane, in m. */
  public static final double POST_DISTANCE = 6.0;

  /** Distance of the rear sides of two posts along that line, in m; one is at its start. */
  public static final double POST_SPACING = 25.0;

  /** Length and width of a post, in m. */
  public static final double POST_WIDTH = 0.3;

  /** Height of a post, in m. */
  public static final double POST_HEIGHT = 3.0;

  private static final double VIEW = 110.0;

  private static final float POST_INTENSITY = 0.5f;

  /** Height of the walls, in m. */
  public static final double WALL_HEIGHT = 2.0;

  /**
   * Returns what is around a sensor in all directions.
   *
   * @param reach from the sensor, in m; somewhat more is included
   */
  static RoadScene around(World world, Road.Place eye, double reach) {
    List<Body> all = new ArrayList<>();
    double seconds = World.seconds(world.now());
    world.actors().forEach(actor -> all.add(actor.body(world.road(), seconds)));
    double along = world.station().along();
    // An arc of up to half a circle is at most pi / 2 times as long as its chord.
    double far = (reach + distance(world.ego().front(), eye)) * Math.PI / 2;
    addPosts(world.road(), along - far, along + far, all);
    List<Body> near = all.stream().filter(body -> isNear(body, eye, reach)).toList();
    return new RoadScene(world.road(), world.ego().front(), near);
  }

  private static boolean isNear(Body body, Road.Place eye, double reach) {
    return distance(body.place(), eye) - body.length() / 2 - body.width() / 2 <= reach;
  }

  private static double distance(Road.Place one, Road.Place other) {
    return StrictMath.hypot(one.x() - other.x(), one.y() - other.y());
  }

  /** Returns the current surroundings ahead of the ego. */
  public static RoadScene of(World world) {
    List<Body> bodies = new ArrayList<>();
    double along = world.station().along();
    double seconds = World.seconds(world.now());
    for (Actor actor : world.actors()) {
      double reach = actor.reach(seconds);
      double ahead = actor.along(seconds) - along;
      if (ahead - reach < VIEW && ahead + reach > -world.ego().shape().length()) {
        bodies.add(actor.body(world.road(), seconds));
      }
    }
    addPosts(world.road(), along, along + VIEW, bodies);
    return new RoadScene(world.road(), world.ego().front(), bodies);
  }

  private static void addPosts(Road road, double from, double to, List<Body> bodies) {
    if (!road.isFurnished()) {
      return;
    }
    double first = Math.floor(from / POST_SPACING) * POST_SPACING + POST_SPACING;
    for (double rear = first; rear < to; rear += POST_SPACING) {
      bodies.add(post(road, rear, POST_DISTANCE));
      bodies.add(post(road, rear, -POST_DISTANCE));
    }
  }

  private static Body post(Road road, double rear, double across) {
    Road.Place place = road.place(rear + POST_WIDTH / 2, across);
    return new Body(place, POST_WIDTH, POST_WIDTH, 0.0, POST_HEIGHT, POST_INTENSITY);
  }
}

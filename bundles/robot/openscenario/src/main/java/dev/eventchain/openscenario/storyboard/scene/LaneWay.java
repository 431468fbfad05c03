package dev.eventchain.openscenario.storyboard.scene;

import dev.eventchain.openscenario.storyboard.world.Angles;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import java.util.List;
import java.util.Optional;

/**
 * A place on a lane that an entity follows.
 *
 * @param alongS whether it goes in the direction of the road's s
 */
public record LaneWay(LanePoint point, boolean alongS) {

  /** Returns that of an entity where it is; empty off the road. */
  public static Optional<LaneWay> of(Scene scene, EntityState state) {
    return state.road().map(point -> of(scene, state.pose(), point));
  }

  private static LaneWay of(Scene scene, Pose pose, LanePoint point) {
    Pose road = scene.roads().pose(scene.roads().road(point));
    return new LaneWay(point, Angles.between(pose.heading(), road.heading()) <= Math.PI / 2);
  }

  /** Returns the place after a way; empty if the road ends before. */
  public Optional<LaneWay> moved(Scene scene, double distance, List<RoadPoint> route) {
    Optional<RoadMap.Moved> moved = scene.roads().move(point, alongS, distance, route);
    return moved.map(each -> new LaneWay(each.point(), each.alongS()));
  }

  /** Returns the pose there, in the direction of the way. */
  public Pose pose(Scene scene) {
    Pose road = scene.roads().pose(scene.roads().road(point));
    return alongS ? road : road.withHeading(road.heading() + Math.PI);
  }

  /** Returns the place with another offset to the left of the lane's centre along s. */
  public LaneWay withOffset(double offset) {
    return new LaneWay(point.withOffset(offset), alongS);
  }

  /** Returns the number of a lane as many lanes to the left as the way goes; empty without one. */
  public Optional<Integer> beside(Scene scene, int lanes) {
    List<Integer> all = scene.roads().lanes(point.road(), point.s());
    int own = all.indexOf(point.lane());
    int index = own + (alongS ? -lanes : lanes);
    return own >= 0 && index >= 0 && index < all.size()
        ? Optional.of(all.get(index))
        : Optional.empty();
  }

  /** Returns the same place as seen from another lane of the road. */
  public LaneWay onLane(Scene scene, int lane) {
    double t = scene.roads().road(point).t();
    double centre = scene.roads().centre(point.road(), point.s(), lane);
    return new LaneWay(new LanePoint(point.road(), lane, point.s(), t - centre), alongS);
  }
}

package dev.eventchain.simulation.recording;

import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Poses at a moment, in the plane of the road.
 *
 * @param ego the ego's frame, at the middle of its front bumper on the road
 * @param lidarBehind from the ego's frame back to the lidar, in m
 * @param lidarAbove from the ego's frame up to the lidar, in m
 * @param egoBody the ego's body, with its frame at the front end
 * @param actors the others
 */
record ScenePoses(
    Road.Place ego, double lidarBehind, double lidarAbove, Named egoBody, List<Named> actors) {

  /** A named body; its frame is in the middle of it, on the road. */
  record Named(String name, Body body) {}

  /** Returns the current poses of the world. */
  static ScenePoses of(World world, EgoVehicle vehicle) {
    double now = World.seconds(world.now());
    List<Named> actors = new ArrayList<>();
    Set<String> names = new HashSet<>(Set.of(SceneMessages.MAP, SceneMessages.EGO));
    for (Actor actor : world.actors()) {
      String plain = actor.name().replaceAll("[^\\p{L}\\p{N}_]+", "_");
      String name = plain;
      for (int i = 2; !names.add(name); i++) {
        name = plain + "_" + i;
      }
      actors.add(new Named(name, actor.body(world.road(), now)));
    }
    return new ScenePoses(
        world.ego().front(),
        vehicle.lidar().behindBumper(),
        vehicle.lidar().aboveRoad(),
        new Named("ego", world.ego().body()),
        actors);
  }
}

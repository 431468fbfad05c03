package dev.eventchain.simulation.stage;

import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.roads.RoadNetwork;
import dev.eventchain.roads.RoadPosition;
import dev.eventchain.roads.road.RoadObject;
import dev.eventchain.roads.road.Signal;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Track;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** The objects and signals of a road map as actors that stand beside, on or over the road. */
final class RoadFurniture {

  /** Height below which something is a mark on the ground, in m. */
  private static final double FLAT = 0.01;

  /** Thickness of the sides of something with an outline, and of a sign, in m. */
  private static final double THIN = 0.1;

  /** Distance from the ego's lane up to which it matters, in m: more than a sensor sees. */
  private static final double ASIDE = 120.0;

  private final RoadNetwork network;
  private final Frame frame;
  private final Road road;
  private final List<Actor> actors = new ArrayList<>();
  private final Set<String> names;

  /**
   * Puts up all objects and signals along a road.
   *
   * @param names those of the scenario's entities, which no object has then
   */
  RoadFurniture(RoadNetwork network, Frame frame, Road road, Set<String> names) {
    this.network = network;
    this.frame = frame;
    this.road = road;
    this.names = new HashSet<>(names);
    for (dev.eventchain.roads.road.Road each : network.roads()) {
      each.objects().forEach(this::add);
      each.signals().forEach(this::add);
    }
  }

  List<Actor> actors() {
    return actors;
  }

  private void add(RoadObject object) {
    ActorKind kind =
        object.type().equals("barrier") || object.type().equals("railing")
            ? ActorKind.GUARD_RAIL
            : ActorKind.OBSTACLE;
    String name =
        object.name().isBlank() ? (object.type() + " " + object.id()).strip() : object.name();
    for (RoadObject.Body body : object.bodies()) {
      if (body.outlines().isEmpty()) {
        double across = body.radius().map(radius -> 2 * radius).orElse(body.width());
        double along = body.radius().map(radius -> 2 * radius).orElse(body.length());
        add(name, kind, body.pose(), along, across, body.height());
      }
      body.outlines().forEach(outline -> add(name, kind, outline));
    }
  }

  /** Adds the sides of an outline, since its box may hold the road. */
  private void add(String name, ActorKind kind, RoadObject.Outline outline) {
    List<RoadObject.Corner> corners = outline.corners();
    int sides = outline.closed() ? corners.size() : corners.size() - 1;
    for (int i = 0; i < sides; i++) {
      RoadObject.Corner from = corners.get(i);
      RoadObject.Corner to = corners.get((i + 1) % corners.size());
      double x = to.x() - from.x();
      double y = to.y() - from.y();
      dev.eventchain.roads.road.Pose middle =
          new dev.eventchain.roads.road.Pose(
              (from.x() + to.x()) / 2,
              (from.y() + to.y()) / 2,
              Math.min(from.z(), to.z()),
              StrictMath.atan2(y, x),
              0.0,
              0.0);
      double height = Math.max(from.height(), to.height());
      add(name, kind, middle, StrictMath.hypot(x, y), THIN, height);
    }
  }

  private void add(Signal signal) {
    String name = signal.name().isBlank() ? "signal " + signal.id() : signal.name();
    add(name, ActorKind.OBSTACLE, signal.pose(), THIN, signal.width(), signal.height());
  }

  private void add(
      String name,
      ActorKind kind,
      dev.eventchain.roads.road.Pose pose,
      double length,
      double width,
      double height) {
    if (height < FLAT || length <= 0.0 || width <= 0.0) {
      return;
    }
    Road.Place place = frame.toWorld(Pose.flat(pose.x(), pose.y(), pose.heading()));
    Track.Moment moment = new Track.Moment(place, 0.0, 0.0);
    Track track = new Track(road);
    track.put(0, moment, moment);
    if (Math.abs(track.station(0.0).across()) > ASIDE + length) {
      return;
    }
    double bottom = Math.max(0.0, pose.z() - ground(pose));
    actors.add(
        new Actor(
            unique(name), kind, new Actor.Size(length, width, bottom, bottom + height), track));
  }

  private double ground(dev.eventchain.roads.road.Pose pose) {
    RoadPosition below = network.nearest(pose.x(), pose.y());
    return network.road(below.road()).orElseThrow().pose(below.s(), below.t()).z();
  }

  private String unique(String name) {
    String unique = name;
    for (int number = 2; !names.add(unique); number++) {
      unique = name + " " + number;
    }
    return unique;
  }
}

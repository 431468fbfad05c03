package dev.eventchain.simulation.stage;

import dev.eventchain.openscenario.storyboard.world.Box;
import dev.eventchain.openscenario.storyboard.world.Entity;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.Track;
import java.util.Map;

/** Entities as actors of the world. */
final class Cast {

  private static final Map<String, ActorKind> KINDS =
      Map.ofEntries(
          Map.entry("truck", ActorKind.LORRY),
          Map.entry("bus", ActorKind.LORRY),
          Map.entry("trailer", ActorKind.LORRY),
          Map.entry("semitrailer", ActorKind.LORRY),
          Map.entry("train", ActorKind.LORRY),
          Map.entry("tram", ActorKind.LORRY),
          Map.entry("motorbike", ActorKind.MOTORCYCLE),
          Map.entry("bicycle", ActorKind.BICYCLE),
          Map.entry("barrier", ActorKind.GUARD_RAIL),
          Map.entry("railing", ActorKind.GUARD_RAIL),
          Map.entry("gantry", ActorKind.OVERHEAD_SIGN),
          Map.entry("patch", ActorKind.STEEL_PLATE),
          Map.entry("building", ActorKind.BRIDGE));

  private Cast() {}

  /** Returns the actor of an entity. */
  static Actor actor(Entity entity, Track track) {
    Box box = entity.box();
    double bottom = Math.max(0.0, box.z() - box.height() / 2);
    Actor.Size size = new Actor.Size(box.length(), box.width(), bottom, box.z() + box.height() / 2);
    return new Actor(entity.name(), kind(entity), size, track);
  }

  private static ActorKind kind(Entity entity) {
    return switch (entity.kind()) {
      case "pedestrian" -> ActorKind.PEDESTRIAN;
      case "miscellaneous" -> KINDS.getOrDefault(entity.category(), ActorKind.OBSTACLE);
      default -> KINDS.getOrDefault(entity.category(), ActorKind.CAR);
    };
  }
}

package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.position.Placement;
import dev.eventchain.openscenario.storyboard.position.Position;
import dev.eventchain.openscenario.storyboard.position.Positions;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Visibility;
import java.util.Optional;

/** Places entities, and says who sees them. */
final class TeleportActions {

  private TeleportActions() {}

  static PrivateAction read(ScenarioElement action) {
    Position position = Positions.read(action.required("Position"));
    return (scene, actor) -> {
      teleport(scene, actor, position);
      return Optional.empty();
    };
  }

  /** Places an entity, which keeps its speed. */
  static void teleport(Scene scene, Actor actor, Position position) {
    Placement there = position.in(scene);
    EntityState before = actor.state();
    actor.place(
        scene,
        EntityState.along(there.pose(), before.speed(), there.road())
            .withVisibility(before.visibility()));
  }

  static PrivateAction visibility(ScenarioElement action) {
    Visibility visibility =
        new Visibility(action.flag("graphics"), action.flag("sensors"), action.flag("traffic"));
    return (scene, actor) -> {
      actor.show(actor.state().withVisibility(visibility));
      return Optional.empty();
    };
  }
}

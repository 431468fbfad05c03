package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.position.Path;
import dev.eventchain.openscenario.storyboard.position.Paths;
import dev.eventchain.openscenario.storyboard.position.Placement;
import dev.eventchain.openscenario.storyboard.position.Position;
import dev.eventchain.openscenario.storyboard.position.Positions;
import dev.eventchain.openscenario.storyboard.position.Trajectory;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.KeepLane;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import dev.eventchain.openscenario.storyboard.world.ControlDomain;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Trajectories and routes. A vehicle that follows a lane takes its route by the lanes, where they
 * part; all else goes straight from waypoint to waypoint.
 */
final class RoutingActions {

  /** Distance in which a waypoint is reached, in m. */
  private static final double HERE = 1e-3;

  private RoutingActions() {}

  static PrivateAction read(ScenarioElement action) {
    return switch (action.name()) {
      case "FollowTrajectoryAction" -> trajectory(action);
      case "AssignRouteAction" -> route(action);
      case "AcquirePositionAction" -> acquire(action);
      default -> throw new IllegalArgumentException(action.name() + " is not supported");
    };
  }

  private static PrivateAction trajectory(ScenarioElement action) {
    Trajectory trajectory = Trajectory.of(action);
    double offset = action.number("initialDistanceOffset", 0);
    Optional<ScenarioElement> timing = action.required("TimeReference").child("Timing");
    return (scene, actor) -> {
      Path path = trajectory.in(scene);
      Task task = new Task(actor.entity().name());
      double begin = Math.min(offset, path.length());
      boolean timed = timing.isPresent() && path.isTimed();
      if (timed) {
        boolean absolute = timing.get().text("domainAbsoluteRelative").equals("absolute");
        TimedWay course =
            new TimedWay(
                path,
                timing.get().number("offset"),
                timing.get().number("scale"),
                absolute ? scene.time() : 0);
        begin = course.begin();
        actor.speed(course.firstSpeed());
        actor.drive(scene, task, course);
      }
      if (!actor.decides(ControlDomain.LATERAL)) {
        place(scene, actor, path.pose(begin));
      }
      actor.steer(scene, task, new OnPath(path, begin, trajectory.isClosed() && !timed));
      return Optional.of(task);
    };
  }

  private static void place(Scene scene, Actor actor, Pose pose) {
    EntityState before = actor.state();
    actor.place(
        scene,
        EntityState.along(pose, before.speed(), scene.roads().find(pose))
            .withVisibility(before.visibility()));
  }

  private static PrivateAction route(ScenarioElement action) {
    List<Position> waypoints =
        action.required("Route").children("Waypoint").stream()
            .map(each -> Positions.read(each.required("Position")))
            .toList();
    return (scene, actor) -> {
      List<Placement> places = waypoints.stream().map(each -> each.in(scene)).toList();
      if (usesLanes(actor)) {
        actor.route(
            places.stream()
                .flatMap(each -> each.road().stream())
                .map(scene.roads()::road)
                .toList());
      } else {
        path(actor, places.stream().map(Placement::pose).toList())
            .ifPresent(path -> actor.follow(new OnPath(path, 0, false)));
      }
      return Optional.empty();
    };
  }

  private static boolean usesLanes(Actor actor) {
    return actor.entity().kind().equals("vehicle") && actor.lateral() instanceof KeepLane;
  }

  /** Returns the path from where an entity is; empty if it is at all points already. */
  private static Optional<Path> path(Actor actor, List<Pose> waypoints) {
    List<Pose> points = new ArrayList<>(List.of(actor.state().pose()));
    for (Pose each : waypoints) {
      if (each.distance(points.get(points.size() - 1)) > HERE) {
        points.add(each);
      }
    }
    return points.size() > 1 ? Optional.of(Paths.through(points)) : Optional.empty();
  }

  private static PrivateAction acquire(ScenarioElement action) {
    Position position = Positions.read(action.required("Position"));
    return (scene, actor) -> {
      Placement there = position.in(scene);
      Task task = new Task(actor.entity().name());
      if (usesLanes(actor) && there.road().isPresent()) {
        RoadPoint aim = scene.roads().road(there.road().get());
        actor.route(List.of(aim));
        actor.steer(scene, task, new LaneTo((KeepLane) actor.lateral(), aim));
        return Optional.of(task);
      }
      Optional<Path> path = path(actor, List.of(there.pose()));
      path.ifPresent(each -> actor.steer(scene, task, new OnPath(each, 0, false)));
      return path.map(each -> task);
    };
  }
}

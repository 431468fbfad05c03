package dev.eventchain.simulation.export;

import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.SpeedProfile;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The maneuvers of one script as events. */
final class ScriptedEvents {

  private final Mover mover;
  private final RoadFrame frame;
  private final Timeline timeline;

  ScriptedEvents(Mover mover, RoadFrame frame, Timeline timeline) {
    this.mover = mover;
    this.frame = frame;
    this.timeline = timeline;
  }

  /** Returns the group of all maneuvers; empty if nothing is done. */
  Optional<Markup> group(List<Markup> waiting) {
    String entity = mover.entity();
    List<Markup> maneuvers = new ArrayList<>();
    maneuver(entity + " speed", speeds()).ifPresent(maneuvers::add);
    maneuver(entity + " line", lines()).ifPresent(maneuvers::add);
    maneuver(entity + " sequence", waiting).ifPresent(maneuvers::add);
    Markup actors =
        new Markup("Actors")
            .with("selectTriggeringEntities", "false")
            .add(new Markup("EntityRef").with("entityRef", entity));
    return maneuvers.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new Markup("ManeuverGroup")
                .with("name", entity + " maneuvers")
                .with("maximumExecutionCount", "1")
                .add(actors)
                .add(maneuvers));
  }

  private static Optional<Markup> maneuver(String name, List<Markup> events) {
    return events.isEmpty()
        ? Optional.empty()
        : Optional.of(new Markup("Maneuver").with("name", name).add(events));
  }

  private List<Markup> speeds() {
    List<Markup> events = new ArrayList<>();
    for (SpeedProfile.Change change : timeline.speedChanges()) {
      String name = mover.entity() + " speed " + (events.size() + 1);
      events.add(at(change.time(), name, speed(change, paceAt(change.time()))));
    }
    return events;
  }

  /** Returns how fast it drives for 1 m/s along the ego's lane. */
  double paceAt(double seconds) {
    return mover.followsTheRoad() ? frame.pace(mover.motion().line().offset(seconds)) : 1.0;
  }

  private List<Markup> lines() {
    List<Markup> events = new ArrayList<>();
    for (LateralProfile.Move move : timeline.laneChanges()) {
      String name = mover.entity() + " lane change " + (events.size() + 1);
      events.add(at(timeline.begin(move), name, laneChange(move)));
    }
    for (Timeline.Span span : timeline.trajectories()) {
      String name = mover.entity() + " way " + (events.size() + 1);
      double last = mover.motion().speed().speed(span.to()) * paceAt(span.to());
      events.add(at(span.from(), name, Trajectory.timed(mover, name, span)));
      events.add(at(span.to(), name + " driven", step(Markup.number(last))));
    }
    return events;
  }

  private static Markup at(double seconds, String name, Markup action) {
    return event(name, action, List.of(List.of(Triggers.since(seconds))), 0.0);
  }

  /**
   * Returns an event.
   *
   * @param groups what starts it
   * @param delay how long ago that came, in s
   */
  static Markup event(String name, Markup action, List<List<Markup>> groups, double delay) {
    return new Markup("Event")
        .with("name", name)
        .with("priority", "parallel")
        .with("maximumExecutionCount", "1")
        .add(
            new Markup("Action").with("name", name + " action").add(action),
            Triggers.trigger("StartTrigger", groups, delay));
  }

  /** Returns a change of the speed. */
  static Markup speed(SpeedProfile.Change change, double pace) {
    return speed(
        "linear", change.acceleration() * pace, "rate", Markup.number(change.speed() * pace));
  }

  /** Returns a change of the speed at once. */
  static Markup step(String speed) {
    return speed("step", 0.0, "time", speed);
  }

  private static Markup speed(String shape, double value, String dimension, String speed) {
    Markup target =
        new Markup("SpeedActionTarget").add(new Markup("AbsoluteTargetSpeed").with("value", speed));
    Markup action =
        new Markup("SpeedAction")
            .add(dynamics("SpeedActionDynamics", shape, value, dimension), target);
    return new Markup("PrivateAction").add(new Markup("LongitudinalAction").add(action));
  }

  /** Returns a move to the side along half a wave; of no length if it stays where it is. */
  static Markup laneChange(LateralProfile.Move move) {
    String shape = move.duration() > 0.0 ? "sinusoidal" : "step";
    Markup target =
        new Markup("LaneChangeTarget")
            .add(new Markup("AbsoluteTargetLane").with("value", RoadFrame.LANE));
    Markup action =
        new Markup("LaneChangeAction")
            .with("targetLaneOffset", move.to())
            .add(dynamics("LaneChangeActionDynamics", shape, move.duration(), "time"), target);
    return new Markup("PrivateAction").add(new Markup("LateralAction").add(action));
  }

  private static Markup dynamics(String name, String shape, double value, String dimension) {
    return new Markup(name)
        .with("dynamicsShape", shape)
        .with("value", value)
        .with("dynamicsDimension", dimension);
  }
}

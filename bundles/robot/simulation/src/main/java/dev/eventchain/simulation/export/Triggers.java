package dev.eventchain.simulation.export;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.ActorSignals;
import dev.eventchain.simulation.formula.Inequality;
import dev.eventchain.simulation.scenario.Circumstance;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Motion;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.SpeedProfile;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/** Conditions of a scenario as groups of conditions of OpenSCENARIO. */
final class Triggers {

  private final Situation situation;
  private final EntityNames names;
  private final Consumer<Diagnostic> findings;

  Triggers(Situation situation, EntityNames names, Consumer<Diagnostic> findings) {
    this.situation = situation;
    this.names = names;
    this.findings = findings;
  }

  /** Returns a condition of the simulated time, in s. */
  static Markup since(double seconds) {
    return new Markup("ByValueCondition")
        .add(
            new Markup("SimulationTimeCondition")
                .with("rule", "greaterOrEqual")
                .with("value", seconds));
  }

  /** Returns a condition of an event's state. */
  static Markup state(String event, String state) {
    return new Markup("ByValueCondition")
        .add(
            new Markup("StoryboardElementStateCondition")
                .with("storyboardElementType", "event")
                .with("storyboardElementRef", event)
                .with("state", state));
  }

  /**
   * Returns a trigger.
   *
   * @param groups conditions without their frames: all of a group, any of the groups
   * @param delay how long ago they were true, in s
   */
  static Markup trigger(String element, List<List<Markup>> groups, double delay) {
    Markup trigger = new Markup(element);
    for (List<Markup> group : groups) {
      Markup all = new Markup("ConditionGroup");
      for (int i = 0; i < group.size(); i++) {
        all.add(
            new Markup("Condition")
                .with("name", "condition " + (i + 1))
                .with("delay", delay)
                .with("conditionEdge", "none")
                .add(group.get(i)));
      }
      trigger.add(all);
    }
    return trigger;
  }

  /**
   * Returns the groups of a condition; none, with a finding, if it cannot be said.
   *
   * @param place where it is written
   */
  List<List<Markup>> groups(Circumstance circumstance, SourceLocation place) {
    Optional<List<List<Inequality>>> alternatives = circumstance.formula().alternatives();
    if (alternatives.isEmpty()) {
      refuse(place, circumstance.formula().text(), "it has too many alternatives");
      return List.of();
    }
    List<List<Markup>> groups = new ArrayList<>();
    for (List<Inequality> all : alternatives.get()) {
      List<Markup> group = new ArrayList<>();
      for (Inequality each : all) {
        Optional<Markup> condition = condition(each, place);
        if (condition.isEmpty()) {
          return List.of();
        }
        group.add(condition.get());
      }
      groups.add(group);
    }
    return groups;
  }

  private void refuse(SourceLocation place, String text, String reason) {
    findings.accept(
        Diagnostic.of(
                ExportRules.CONDITION,
                "OpenSCENARIO has no condition for '" + text + "': " + reason + ".",
                place)
            .withHint(
                "Compare one of ego.speed, ego.acceleration, ego.position (above a limit), and"
                    + " gap (below a limit), distance, ttc and speed of an actor with a number,"
                    + " or ego.speed with the speed of an actor."));
  }

  private Optional<Markup> condition(Inequality each, SourceLocation place) {
    Map<String, Double> factors = each.factors().orElse(Map.of());
    if (factors.size() == 2) {
      Optional<Markup> speeds = speeds(each, factors);
      if (speeds.isEmpty()) {
        refuse(place, each.text(), "it compares two quantities");
      }
      return speeds;
    }
    if (factors.size() != 1) {
      refuse(place, each.text(), "it is no comparison of one quantity with a number");
      return Optional.empty();
    }
    Map.Entry<String, Double> only = factors.entrySet().iterator().next();
    Limit limit =
        new Limit(only.getValue() > 0.0, each.strict(), -each.constant() / only.getValue());
    Optional<ActorSignals.Reading> actor = ActorSignals.reading(only.getKey());
    Answer found = actor.map(it -> ofActor(it, limit)).orElseGet(() -> ofEgo(only.getKey(), limit));
    if (found.condition().isEmpty()) {
      refuse(place, each.text(), found.reason());
    }
    return found.condition();
  }

  /** A condition, or the reason why there is none. */
  private record Answer(Optional<Markup> condition, String reason) {

    static Answer of(String entity, Markup condition) {
      return new Answer(Optional.of(about(entity, condition)), "");
    }

    static Answer none(String reason) {
      return new Answer(Optional.empty(), reason);
    }
  }

  /** A limit of a quantity, and whether that has to be above it. */
  private record Limit(boolean above, boolean strict, double value) {

    Markup of(Markup condition) {
      String rule =
          above ? (strict ? "greaterThan" : "greaterOrEqual") : strict ? "lessThan" : "lessOrEqual";
      return condition.with("rule", rule).with("value", value);
    }

    Limit mirrored() {
      return new Limit(!above, strict, -value);
    }
  }

  private static Markup about(String entity, Markup condition) {
    Markup who =
        new Markup("TriggeringEntities")
            .with("triggeringEntitiesRule", "any")
            .add(new Markup("EntityRef").with("entityRef", entity));
    return new Markup("ByEntityCondition").add(who, new Markup("EntityCondition").add(condition));
  }

  private static Answer ofEgo(String signal, Limit limit) {
    return switch (signal) {
      case "ego.speed" -> Answer.of(EntityNames.EGO, speed(limit));
      case "ego.acceleration" ->
          Answer.of(
              EntityNames.EGO,
              limit.of(new Markup("AccelerationCondition")).with("direction", "longitudinal"));
      case "ego.position" ->
          limit.above() && limit.value() >= 0.0
              ? Answer.of(
                  EntityNames.EGO,
                  new Markup("TraveledDistanceCondition").with("value", limit.value()))
              : Answer.none("a driven distance is only asked for from a limit on");
      case "gap", "ttc", "lead.speed" ->
          Answer.none("it is about whatever is in the way, and not one actor");
      default -> Answer.none("it does not know " + signal);
    };
  }

  private static Markup speed(Limit limit) {
    return limit.of(new Markup("SpeedCondition")).with("direction", "longitudinal");
  }

  private Answer ofActor(ActorSignals.Reading reading, Limit limit) {
    Actor actor = actor(reading.name());
    String entity = names.of(actor.name());
    return switch (reading.quantity()) {
      case "distance" -> Answer.of(EntityNames.EGO, distance(entity, "euclidianDistance", limit));
      case "gap" ->
          limit.above() || limit.value() <= 0.0 || actor.rear(0.0) <= 0.0
              ? Answer.none("its distances have no sign, so that ahead and behind are the same")
              : Answer.of(EntityNames.EGO, distance(entity, "longitudinal", limit));
      case "ttc" ->
          limit.value() > 0.0
              ? Answer.of(EntityNames.EGO, timeToCollision(entity, limit))
              : Answer.none("a time to collision is above 0");
      case "speed" -> speed(actor, entity, limit);
      default -> Answer.none("it does not know an actor's " + reading.quantity());
    };
  }

  private Answer speed(Actor actor, String entity, Limit limit) {
    if (sign(actor) == 0.0) {
      return Answer.none("the actor does not drive along the road");
    }
    if (!isMeasuredAlike(actor)) {
      return Answer.none("beside the ego's lane, a speed in a bend is another one there");
    }
    return Answer.of(entity, speed(sign(actor) > 0.0 ? limit : limit.mirrored()));
  }

  private Markup distance(String entity, String type, Limit limit) {
    Markup distance =
        new Markup("RelativeDistanceCondition")
            .with("entityRef", entity)
            .with("relativeDistanceType", type)
            .with("coordinateSystem", type.equals("longitudinal") ? along() : "entity")
            .with("freespace", "true");
    return limit.of(distance);
  }

  private Markup timeToCollision(String entity, Limit limit) {
    Markup target = new Markup("EntityRef").with("entityRef", entity);
    Markup condition =
        limit
            .of(new Markup("TimeToCollisionCondition"))
            .with("freespace", "true")
            .with("relativeDistanceType", "longitudinal")
            .with("coordinateSystem", along());
    return condition.add(new Markup("TimeToCollisionConditionTarget").add(target));
  }

  /** Returns the condition of the ego's speed and that of an actor in the same direction. */
  private Optional<Markup> speeds(Inequality each, Map<String, Double> factors) {
    Double own = factors.get("ego.speed");
    for (Map.Entry<String, Double> other : factors.entrySet()) {
      Optional<ActorSignals.Reading> actor = ActorSignals.reading(other.getKey());
      boolean isSpeed = actor.filter(it -> it.quantity().equals("speed")).isPresent();
      if (own != null && isSpeed && own + other.getValue() == 0.0) {
        Actor driven = actor(actor.get().name());
        if (sign(driven) <= 0.0 || !isMeasuredAlike(driven)) {
          return Optional.empty();
        }
        Limit limit = new Limit(own > 0.0, each.strict(), -each.constant() / own);
        Markup condition =
            new Markup("RelativeSpeedCondition").with("entityRef", names.of(driven.name()));
        return Optional.of(
            about(EntityNames.EGO, limit.of(condition).with("direction", "longitudinal")));
      }
    }
    return Optional.empty();
  }

  private Actor actor(String name) {
    return situation.actors().stream()
        .filter(it -> it.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  /** Returns along what distances are measured: that of the ego's lane, as in the scenario. */
  private String along() {
    return situation.road().isStraight() ? "road" : "lane";
  }

  /** Returns whether the speed along the ego's lane is the speed. */
  private boolean isMeasuredAlike(Actor actor) {
    Motion motion = actor.script().orElseThrow();
    boolean inLane =
        actor.across(0.0) == 0.0
            && motion.line().changes().isEmpty()
            && motion.waiting().stream().allMatch(it -> it.change() instanceof SpeedProfile.Change);
    return situation.road().isStraight() || inLane;
  }

  /** Returns 1 for an actor that drives along the road, -1 for one against it, else 0. */
  private static double sign(Actor actor) {
    return Mover.sign(actor.direction());
  }
}

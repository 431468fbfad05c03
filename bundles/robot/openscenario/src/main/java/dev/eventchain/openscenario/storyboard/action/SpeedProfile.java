package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A sequence of speeds with straight lines between them. An entry without a time is reached as fast
 * as the constraints, and otherwise the vehicle, allow.
 *
 * @param elapsed the time since its begin, in s
 */
record SpeedProfile(List<Transition> parts, double elapsed) implements Longitudinal {

  static PrivateAction read(ScenarioElement action) {
    return (scene, actor) -> {
      SpeedProfile profile = new SpeedProfile(parts(action, actor), 0);
      Task task = new Task(actor.entity().name());
      actor.drive(scene, task, profile);
      return Optional.of(task);
    };
  }

  private static List<Transition> parts(ScenarioElement action, Actor actor) {
    boolean follow = action.text("followingMode").equals("follow");
    Limits limits =
        action
            .child("DynamicConstraints")
            .map(Limits::of)
            .orElse(
                new Limits(
                    Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY))
            .within(actor.entity().performance());
    List<Transition> parts = new ArrayList<>();
    double from = actor.state().speed();
    for (ScenarioElement each : action.children("SpeedProfileEntry")) {
      double to = Math.max(-limits.speed(), Math.min(limits.speed(), each.number("speed")));
      double least = Math.abs(to - from) / limits.rate(from, to);
      double duration = each.has("time") ? each.number("time") : least;
      parts.add(
          new Transition(Shape.LINEAR, from, to, follow ? Math.max(duration, least) : duration));
      from = to;
    }
    return parts;
  }

  @Override
  public Step step(Scene scene, Actor actor, double dt) {
    double after = elapsed + dt;
    double begin = 0;
    for (Transition each : parts) {
      if (after < begin + each.duration() - SpeedChange.NOTHING) {
        return step(after, dt, each.value(after - begin), each.rate(after - begin), false);
      }
      begin += each.duration();
    }
    return step(after, dt, parts.get(parts.size() - 1).to(), 0, true);
  }

  private Step step(double after, double dt, double speed, double rate, boolean done) {
    double way = integral(after) - integral(after - dt);
    return new Step(way, speed, rate, new SpeedProfile(parts, after), done);
  }

  private double integral(double time) {
    double sum = 0;
    double rest = time;
    for (Transition each : parts) {
      if (each.duration() > 0) {
        sum += each.integral(Math.min(rest, each.duration()));
      }
      rest = Math.max(0, rest - each.duration());
    }
    return sum + rest * parts.get(parts.size() - 1).to();
  }
}

package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.action.Synchronizing.Plan;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import java.util.Optional;

/**
 * The speed at the end of a synchronization.
 *
 * @param written empty if any speed will do
 */
record FinalSpeed(Optional<ScenarioElement> written) {

  static FinalSpeed of(ScenarioElement action) {
    return new FinalSpeed(action.child("FinalSpeed").map(ScenarioElement::choice));
  }

  /** Returns the speed from now that covers a distance in a time, which may be infinite. */
  Plan plan(Scene scene, String master, double before, double distance, double time) {
    if (Double.isInfinite(time)) {
      return meanSpeed(before, 0);
    }
    if (written.isEmpty()) {
      Plan plan = new Plan(before, 2 * (distance - before * time) / (time * time), 0);
      return plan.isBackward(time) ? meanSpeed(before, distance / time) : plan;
    }
    double last = speed(scene, master);
    double steady = steady(last);
    double way = distance - steady;
    double rest = last > 0 ? time - steady / last : time;
    if (way <= 0 || rest <= 0) {
      return meanSpeed(before, last);
    }
    Plan plan =
        new Plan(
            before,
            (6 * way - 2 * rest * (2 * before + last)) / (rest * rest),
            (6 * rest * (before + last) - 12 * way) / (rest * rest * rest));
    return plan.isBackward(rest) ? meanSpeed(before, distance / time) : plan;
  }

  /** Returns a plan to be at a speed at once, as far as the entity can. */
  private static Plan meanSpeed(double before, double speed) {
    return speed == before ? new Plan(before, 0, 0) : new Plan(speed, 0, 0);
  }

  private double speed(Scene scene, String master) {
    ScenarioElement speed = written.orElseThrow();
    double value = speed.number("value");
    if (speed.name().equals("AbsoluteSpeed")) {
      return value;
    }
    double other = scene.state(master).speed();
    return speed.text("speedTargetValueType").equals("factor") ? other * value : other + value;
  }

  /** Returns the distance before the end in which the final speed is kept. */
  private double steady(double last) {
    ScenarioElement speed = written.orElseThrow();
    return speed
        .child("TargetDistanceSteadyState")
        .map(each -> each.number("distance"))
        .or(() -> speed.child("TargetTimeSteadyState").map(each -> each.number("time") * last))
        .orElse(0.0);
  }
}

package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;

/** A speed that may be relative to that of an entity. */
@FunctionalInterface
interface SpeedTarget {

  /** Returns it now, in m/s. */
  double in(Scene scene);

  /** Reads an absolute or relative target. */
  static SpeedTarget of(ScenarioElement target) {
    double value = target.number("value");
    if (target.name().equals("AbsoluteTargetSpeed")) {
      return scene -> value;
    }
    String entity = target.text("entityRef");
    return target.text("speedTargetValueType").equals("factor")
        ? scene -> scene.state(entity).speed() * value
        : scene -> scene.state(entity).speed() + value;
  }
}

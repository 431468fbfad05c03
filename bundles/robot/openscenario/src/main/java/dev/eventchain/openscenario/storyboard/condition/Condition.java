package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import java.util.Map;
import java.util.TreeMap;

/**
 * A condition with its edge and its delay. It remembers what it was, since the time it was reset.
 */
final class Condition {

  private static final double NANOS = 1e9;

  private final Test test;
  private final Edge edge;
  private final long delay;

  /** Values by time in ns, as far back as the delay asks. */
  private final TreeMap<Long, Outcome> outcomes = new TreeMap<>();

  private long step = -1;
  private Boolean before;
  private Boolean now;

  Condition(ScenarioElement written, Test test) {
    this.test = test;
    edge = Edge.of(written.optional("conditionEdge").orElse("none"));
    delay = Math.round(written.number("delay", 0) * NANOS);
  }

  /** Forgets what it was. */
  void reset() {
    outcomes.clear();
    step = -1;
    before = null;
    now = null;
  }

  /** Returns what it is now; what counts for the next step is the last answer in a step. */
  Outcome in(Scene scene) {
    if (scene.step() != step) {
      before = now;
      step = scene.step();
    }
    Outcome outcome = test.in(scene);
    now = outcome.holds();
    Outcome result = edge.holds(before, now) ? new Outcome(true, outcome.entities()) : Outcome.NO;
    if (delay <= 0) {
      return result;
    }
    outcomes.put(scene.nanos(), result);
    Map.Entry<Long, Outcome> then = outcomes.floorEntry(scene.nanos() - delay);
    if (then == null) {
      return Outcome.NO;
    }
    outcomes.headMap(then.getKey()).clear();
    return then.getValue();
  }
}

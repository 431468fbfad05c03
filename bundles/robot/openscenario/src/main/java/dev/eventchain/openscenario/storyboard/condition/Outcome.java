package dev.eventchain.openscenario.storyboard.condition;

import java.util.List;

/**
 * Value of a condition or a trigger.
 *
 * @param entities those that made it hold, without doubles; empty for conditions on values
 */
public record Outcome(boolean holds, List<String> entities) {

  static final Outcome NO = new Outcome(false, List.of());
  static final Outcome YES = new Outcome(true, List.of());

  static Outcome of(boolean holds) {
    return holds ? YES : NO;
  }
}

package dev.eventchain.simulation.formula;

import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import java.util.Optional;

/**
 * What a judgement of a scenario found.
 *
 * @param tested whether what it is about ever came up; if not, it neither holds nor fails
 * @param passed whether it was tested and holds
 * @param detail the figures that say so
 * @param margin how far what decides is from the other verdict; empty where it has no size
 */
public record Outcome(boolean tested, boolean passed, String detail, Optional<Margin> margin) {

  public Outcome(boolean passed, String detail) {
    this(true, passed, detail, Optional.empty());
  }

  public Outcome(boolean passed, String detail, Margin margin) {
    this(true, passed, detail, Optional.of(margin));
  }

  /** Of a criterion whose premise never came true. */
  public static Outcome untested(String why) {
    return new Outcome(false, false, why, Optional.empty());
  }
}

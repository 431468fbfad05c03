package dev.eventchain.simulation.scenario;

import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.world.Trace;
import java.util.function.Predicate;

/** A condition of the trace of a moment, as a scenario writes it. */
public record Circumstance(Formula formula) implements Predicate<Trace> {

  @Override
  public boolean test(Trace moment) {
    return formula.holds(new SampledRun(moment));
  }
}

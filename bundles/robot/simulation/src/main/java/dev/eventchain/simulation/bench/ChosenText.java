package dev.eventchain.simulation.bench;

import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.Term;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A quantity that is published as one of several texts: the first one for 0, the second one for 1.
 *
 * @param text the source text of the quantity
 */
public record ChosenText(String text, Term term, List<String> texts) implements Bench.Source {

  /** Copies the list. */
  public ChosenText {
    texts = List.copyOf(texts);
  }

  /** Returns the text for the nearest whole number; empty if there is none. */
  public Optional<String> at(SampledRun moment) {
    double value = Math.rint(term.values().in(moment).applyAsDouble(0));
    return value >= 0 && value < texts.size()
        ? Optional.of(texts.get((int) value))
        : Optional.empty();
  }

  @Override
  public Object example() {
    return texts.get(0);
  }

  @Override
  public Set<Signal> signals() {
    return term.signals();
  }
}

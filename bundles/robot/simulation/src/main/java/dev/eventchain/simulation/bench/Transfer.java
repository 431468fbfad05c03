package dev.eventchain.simulation.bench;

import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.Term;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;

/**
 * Transfer of messages to the nodes.
 *
 * @param latency from the measurement of a message to its arrival, in ns
 * @param lost the fraction of the messages that are lost, 0 to 1; empty for none
 * @param counted the names of the latency constraints whose times begin with the measurement, not
 *     with the arrival
 */
public record Transfer(long latency, Optional<Term> lost, List<String> counted) {

  /** Copies the list. */
  public Transfer {
    counted = List.copyOf(counted);
  }

  /** Returns the part of the latency that counts in a latency constraint, in ns. */
  public long countedIn(LatencyConstraint constraint) {
    return counted.stream().anyMatch(it -> it.equals(constraint.getName())) ? latency : 0;
  }

  /** Returns whether a message is lost. */
  public boolean loses(SampledRun moment, SplittableRandom random) {
    return lost.isPresent()
        && random.nextDouble() < lost.get().values().in(moment).applyAsDouble(0);
  }

  Transfer later(long delay) {
    return new Transfer(latency + delay, lost, counted);
  }

  Set<Signal> signals() {
    return lost.map(Term::signals).orElse(Set.of());
  }
}

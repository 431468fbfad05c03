package dev.eventchain.pipeline.simulate;

import dev.eventchain.contracts.latency.Stimuli;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.simulation.bench.Bench;
import java.util.OptionalLong;

/** Messages that a bench provides: they come regularly, unless some get lost. */
record BenchStimuli(Bench bench) implements Stimuli {

  @Override
  public OptionalLong interval(String topic) {
    Bench.Provided provided = bench.provided().get(topic);
    return provided == null || provided.transfer().lost().isPresent()
        ? OptionalLong.empty()
        : OptionalLong.of(provided.period());
  }

  @Override
  public long before(String topic, LatencyConstraint constraint) {
    Bench.Provided provided = bench.provided().get(topic);
    return provided == null ? 0 : provided.transfer().countedIn(constraint);
  }
}

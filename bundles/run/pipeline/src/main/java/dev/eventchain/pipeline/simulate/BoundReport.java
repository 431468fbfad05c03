package dev.eventchain.pipeline.simulate;

import dev.eventchain.contracts.latency.LatencyEstimate;
import dev.eventchain.contracts.timing.AlignedTimers;
import dev.eventchain.contracts.timing.Bound;
import dev.eventchain.contracts.timing.LatencyType;
import dev.eventchain.contracts.timing.Sensitivity;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.pipeline.results.BoundedLatency;
import dev.eventchain.pipeline.results.DelayedScenario;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/** Bounds on latencies for the report and {@code latency-bounds.json}. */
final class BoundReport {

  private static final double MILLISECOND = 1e6;

  /** The finest difference that is shown, by a millisecond. */
  private static final double FINEST = 1e3;

  private BoundReport() {}

  static BoundedLatency of(LatencyBounds.Bounded bounded, List<DelayedScenario> delayed) {
    LatencyEstimate estimate = bounded.estimate();
    OptionalLong bound = estimate.bound();
    Optional<Bound> slowest = estimate.slowest().filter(it -> bound.isPresent());
    return new BoundedLatency(
        bounded.constraint().map(LatencyConstraint::getName),
        estimate.type() == LatencyType.DATA_AGE ? "data age" : "reaction",
        bounded.first(),
        bounded.last(),
        maximum(bounded),
        milliseconds(bound),
        slowest.map(estimate::assumption),
        milliseconds(estimate.known()),
        milliseconds(estimate.outside()),
        slowest.map(it -> parts(bounded, it)).orElse(List.of()),
        estimate.unknown(),
        slowest.flatMap(it -> aligned(estimate)),
        bounded.longest().map(BoundReport::measured),
        delayed);
  }

  private static OptionalDouble maximum(LatencyBounds.Bounded bounded) {
    return bounded.constraint().stream()
        .mapToDouble(LatencyConstraint::getMaximum)
        .filter(maximum -> maximum > 0)
        .findFirst();
  }

  private static List<BoundedLatency.Part> parts(LatencyBounds.Bounded bounded, Bound slowest) {
    LatencyEstimate estimate = bounded.estimate();
    OptionalDouble maximum = maximum(bounded);
    long allowed = Math.round(maximum.orElse(0) * MILLISECOND) - estimate.outside();
    Map<String, Sensitivity.Effect> effects =
        Sensitivity.of(estimate.type(), estimate.paths(), allowed);
    double whole = estimate.bound().orElseThrow();
    return slowest.shares().stream()
        .map(
            share -> {
              Optional<Sensitivity.Effect> effect = Optional.ofNullable(effects.get(share.task()));
              return new BoundedLatency.Part(
                  share.task(),
                  milliseconds(share.waiting()),
                  milliseconds(share.response()),
                  Math.round((share.waiting() + share.response()) / whole * 1e3) / 1e1,
                  effect.stream().mapToDouble(it -> milliseconds(it.period())).findFirst(),
                  effect.stream().mapToDouble(it -> milliseconds(it.saved())).findFirst(),
                  maximum.isPresent()
                      ? milliseconds(
                          effect.map(Sensitivity.Effect::largest).orElse(OptionalLong.empty()))
                      : OptionalDouble.empty());
            })
        .toList();
  }

  private static Optional<BoundedLatency.Aligned> aligned(LatencyEstimate estimate) {
    return AlignedTimers.of(estimate.type(), estimate.paths())
        .map(
            aligned -> {
              List<BoundedLatency.Release> releases =
                  aligned.phases().entrySet().stream()
                      .map(
                          it ->
                              new BoundedLatency.Release(it.getKey(), milliseconds(it.getValue())))
                      .toList();
              long time = estimate.outside() + aligned.bound().time();
              return new BoundedLatency.Aligned(milliseconds(time), releases);
            });
  }

  private static BoundedLatency.Measured measured(LatencyBounds.Longest longest) {
    return new BoundedLatency.Measured(
        longest.scenario(),
        milliseconds(longest.time()),
        longest.parts().stream()
            .map(
                part ->
                    new BoundedLatency.MeasuredPart(
                        part.node(), rounded(part.waiting()), rounded(part.execution())))
            .toList());
  }

  private static OptionalDouble milliseconds(OptionalLong nanoseconds) {
    return nanoseconds.isPresent()
        ? OptionalDouble.of(milliseconds(nanoseconds.getAsLong()))
        : OptionalDouble.empty();
  }

  private static double milliseconds(long nanoseconds) {
    return rounded(nanoseconds / MILLISECOND);
  }

  private static double rounded(double milliseconds) {
    return Math.round(milliseconds * FINEST) / FINEST;
  }
}

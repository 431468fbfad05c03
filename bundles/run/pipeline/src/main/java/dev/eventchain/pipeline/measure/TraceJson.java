package dev.eventchain.pipeline.measure;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.simulation.tracing.RecordedTrace;
import dev.eventchain.simulation.tracing.TraceMeasurement;
import dev.eventchain.simulation.verdict.Measurements.Statistics;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The file {@code measurements.json} of a trace. All times are in ms; what was not measured is left
 * out.
 *
 * @param lost which events the trace lacks; empty if none
 * @param missing components that are not in the trace, with the reason
 */
record TraceJson(
    long events,
    List<String> lost,
    List<Component> components,
    Map<String, String> missing,
    List<TraceMeasurement.Hop> messages,
    List<Latency> latencies) {

  private static final double NANOSECONDS = 1e6;

  /** A component with its node. */
  record Component(
      String name,
      String node,
      int activations,
      Optional<Statistics> period,
      Optional<Statistics> jitter,
      Optional<Statistics> executionTime) {}

  /**
   * A latency constraint; without a distribution where it was not measured.
   *
   * @param unanswered the messages that are not in the distribution, since no output is based on
   *     them
   */
  record Latency(
      String constraint,
      OptionalDouble allowed,
      Optional<Statistics> latency,
      Unanswered unanswered,
      List<ScenarioVerdict.Part> slowest) {}

  /** Messages without an output; without the times of which there is none. */
  record Unanswered(int count, OptionalDouble untilLater, OptionalDouble untilEnd) {

    static Unanswered of(TraceMeasurement.Unanswered found) {
      return new Unanswered(found.count(), time(found.untilLater()), time(found.untilEnd()));
    }

    private static OptionalDouble time(double milliseconds) {
      return milliseconds > 0 ? OptionalDouble.of(rounded(milliseconds)) : OptionalDouble.empty();
    }
  }

  static TraceJson of(EventChain chain, RecordedTrace trace, TraceMeasurement measured) {
    List<Latency> latencies = new ArrayList<>();
    for (int i = 0; i < chain.getLatencyConstraints().size(); i++) {
      LatencyConstraint constraint = chain.getLatencyConstraints().get(i);
      Optional<ScenarioVerdict.Latency> found = measured.latencies().get(i);
      double maximum = constraint.getMaximum();
      latencies.add(
          new Latency(
              String.valueOf(constraint.getName()),
              maximum > 0 ? OptionalDouble.of(maximum) : OptionalDouble.empty(),
              found.map(it -> rounded(it.statistics())),
              Unanswered.of(measured.unanswered().get(i)),
              found.stream()
                  .flatMap(it -> it.slowest().stream())
                  .map(TraceJson::rounded)
                  .toList()));
    }
    return new TraceJson(
        trace.events(),
        trace.lost(),
        measured.components().stream().map(TraceJson::component).toList(),
        measured.missing(),
        measured.hops().stream().map(TraceJson::rounded).toList(),
        latencies);
  }

  private static Component component(TraceMeasurement.Component component) {
    return new Component(
        component.times().name(),
        component.node(),
        component.times().activations(),
        component.times().period().map(TraceJson::rounded),
        component.times().jitter().map(TraceJson::rounded),
        component.times().executionTime().map(TraceJson::rounded));
  }

  private static TraceMeasurement.Hop rounded(TraceMeasurement.Hop hop) {
    return new TraceMeasurement.Hop(hop.topic(), hop.reader(), rounded(hop.waiting()));
  }

  private static ScenarioVerdict.Part rounded(ScenarioVerdict.Part part) {
    return new ScenarioVerdict.Part(
        part.node(), rounded(part.waiting()), rounded(part.execution()));
  }

  private static Statistics rounded(Statistics it) {
    return new Statistics(
        it.count(),
        rounded(it.minimum()),
        rounded(it.mean()),
        rounded(it.median()),
        rounded(it.percentile99()),
        rounded(it.maximum()));
  }

  /** Returns a time without what is finer than the ns of a trace. */
  private static double rounded(double milliseconds) {
    return Math.round(milliseconds * NANOSECONDS) / NANOSECONDS;
  }
}

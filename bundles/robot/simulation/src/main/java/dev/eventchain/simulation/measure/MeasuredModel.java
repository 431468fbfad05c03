package dev.eventchain.simulation.measure;

import dev.eventchain.model.eventchain.ChainMeasurement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.LatencyMeasurement;
import dev.eventchain.model.eventchain.LatencyPart;
import dev.eventchain.model.eventchain.Measurement;
import dev.eventchain.model.eventchain.NodeMeasurement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.model.eventchain.StatisticKind;
import dev.eventchain.model.eventchain.Statistics;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Writes measurements into a copy of a chain. */
public final class MeasuredModel {

  private static final EventchainFactory FACTORY = EventchainFactory.eINSTANCE;

  private final Measurements measurements;

  private MeasuredModel(Measurements measurements) {
    this.measurements = measurements;
  }

  public static EventChain of(
      EventChain chain, Measurements measurements, List<ScenarioVerdict> verdicts) {
    MeasuredModel model = new MeasuredModel(measurements);
    EventChain copy = model.copyOf(chain);
    verdicts.forEach(verdict -> copy.getMeasured().add(model.measurement(copy, verdict)));
    return copy;
  }

  /**
   * Returns a copy of a chain with what was measured in a recorded trace.
   *
   * @param name the name of the trace, in the place of a scenario's
   * @param latencies one for each latency constraint of the chain, in its order
   */
  public static EventChain ofTrace(
      EventChain chain,
      Measurements measurements,
      String name,
      List<Optional<ScenarioVerdict.Latency>> latencies,
      boolean passed) {
    MeasuredModel model = new MeasuredModel(measurements);
    EventChain copy = model.copyOf(chain);
    ChainMeasurement measurement = model.measurement(copy, name);
    addLatencies(copy, measurement, latencies);
    measurement.setPassed(passed);
    copy.getMeasured().add(measurement);
    return copy;
  }

  /** Returns a copy with the measurements of components, and no others. */
  private EventChain copyOf(EventChain chain) {
    EventChain copy = EcoreUtil.copy(chain);
    copy.getSoftware().forEach(software -> software.setMeasured(null));
    measurements.nodes().forEach(node -> measure(copy, node));
    copy.getMeasured().clear();
    return copy;
  }

  private void measure(EventChain chain, Measurements.Node node) {
    NodeMeasurement measurement = FACTORY.createNodeMeasurement();
    measurement.setRunId(measurements.runId());
    measurement.setActivations(node.activations());
    statistics(node.period()).ifPresent(measurement::setPeriod);
    statistics(node.jitter()).ifPresent(measurement::setJitter);
    statistics(node.executionTime()).ifPresent(measurement::setExecutionTime);
    find(chain, node.name()).ifPresent(software -> software.setMeasured(measurement));
  }

  private ChainMeasurement measurement(EventChain chain, String scenario) {
    ChainMeasurement measurement = FACTORY.createChainMeasurement();
    measurement.setRunId(measurements.runId());
    measurement.setScenario(scenario);
    find(chain, measurements.firstNode()).ifPresent(measurement::setFirst);
    find(chain, measurements.lastNode()).ifPresent(measurement::setLast);
    return measurement;
  }

  private static void addLatencies(
      EventChain chain,
      ChainMeasurement measurement,
      List<Optional<ScenarioVerdict.Latency>> latencies) {
    for (int i = 0; i < latencies.size(); i++) {
      LatencyConstraint constraint = chain.getLatencyConstraints().get(i);
      latencies
          .get(i)
          .map(latency -> latency(chain, constraint, latency))
          .ifPresent(measurement.getLatencies()::add);
    }
  }

  private ChainMeasurement measurement(EventChain chain, ScenarioVerdict verdict) {
    ChainMeasurement measurement = measurement(chain, verdict.scenario());
    statistics(verdict.latency()).ifPresent(measurement::setLatency);
    addLatencies(chain, measurement, verdict.latencies());
    verdict.figures().forEach(figure -> measurement.getMeasurements().add(figure(figure)));
    verdict.criteria().forEach(each -> margin(each).ifPresent(measurement.getMeasurements()::add));
    measurement.getMeasurements().addAll(MeasuredFlow.of(verdict.flow()));
    measurement.setPassed(verdict.passed());
    return measurement;
  }

  private static Measurement figure(ScenarioVerdict.Figure figure) {
    StatisticKind statistic = StatisticKind.valueOf(figure.statistic().name());
    return measurement(figure.name(), figure.unit(), statistic, figure.value(), figure.time());
  }

  /** Returns the margin as a measurement; empty if it is infinite. */
  private static Optional<Measurement> margin(ScenarioVerdict.CriterionResult criterion) {
    return criterion
        .margin()
        .filter(margin -> Double.isFinite(margin.value()))
        .map(
            margin ->
                measurement(
                    criterion.text(),
                    margin.unit(),
                    StatisticKind.MARGIN,
                    margin.value(),
                    margin.time()));
  }

  private static Measurement measurement(
      String name, String unit, StatisticKind statistic, double value, double time) {
    Measurement measurement = FACTORY.createMeasurement();
    measurement.setName(name);
    measurement.setUnit(unit);
    measurement.setStatistic(statistic);
    measurement.setValue(value);
    measurement.setTime(time);
    return measurement;
  }

  private static LatencyMeasurement latency(
      EventChain chain, LatencyConstraint constraint, ScenarioVerdict.Latency latency) {
    LatencyMeasurement measurement = FACTORY.createLatencyMeasurement();
    measurement.setConstraint(constraint);
    statistics(Optional.of(latency.statistics())).ifPresent(measurement::setLatency);
    latency.slowest().forEach(part -> measurement.getSlowest().add(part(chain, part)));
    return measurement;
  }

  private static LatencyPart part(EventChain chain, ScenarioVerdict.Part part) {
    LatencyPart copy = FACTORY.createLatencyPart();
    find(chain, part.node()).ifPresent(copy::setNode);
    copy.setWaiting(part.waiting());
    copy.setExecution(part.execution());
    return copy;
  }

  private static Optional<SoftwareNode> find(EventChain chain, String name) {
    return chain.getSoftware().stream().filter(node -> name.equals(node.getName())).findFirst();
  }

  private static Optional<Statistics> statistics(Optional<Measurements.Statistics> values) {
    return values.map(
        value -> {
          Statistics statistics = FACTORY.createStatistics();
          statistics.setCount(Math.toIntExact(value.count()));
          statistics.setMinimum(value.minimum());
          statistics.setMedian(value.median());
          statistics.setPercentile99(value.percentile99());
          statistics.setMaximum(value.maximum());
          return statistics;
        });
  }
}

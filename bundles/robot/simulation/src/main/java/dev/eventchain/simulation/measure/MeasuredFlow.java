package dev.eventchain.simulation.measure;

import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.Measurement;
import dev.eventchain.model.eventchain.StatisticKind;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.MessageFlow;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Message flow of a scenario as values of a measured model: {@code waiting on /scan from A to B}.
 * Missing measurements have no value, so that constraints on them are untested.
 */
final class MeasuredFlow {

  private static final String MILLISECOND = "ms";
  private static final String ONE = "1";

  private final List<Measurement> found = new ArrayList<>();

  private MeasuredFlow() {}

  static List<Measurement> of(MessageFlow flow) {
    MeasuredFlow measured = new MeasuredFlow();
    flow.hops().forEach(measured::hop);
    flow.topics().forEach(measured::topic);
    return measured.found;
  }

  private void hop(MessageFlow.Hop hop) {
    longest("waiting", hop, hop.waiting());
    longest("age", hop, hop.age());
    hop.samples().ifPresent(it -> count("never read", hop.words(), it.neverRead()));
    hop.tooOld().ifPresent(it -> count("too old", hop.words(), it.times()));
    hop.late().ifPresent(it -> count("late", hop.words(), it.times()));
  }

  private void topic(MessageFlow.Topic topic) {
    topic.dropped().ifPresent(it -> count("dropped", topic.name(), it));
    topic.lost().ifPresent(it -> count("lost", topic.name(), it));
  }

  private void longest(
      String figure, MessageFlow.Hop hop, Optional<Measurements.Statistics> values) {
    values.ifPresent(
        it -> add(figure, hop.words(), MILLISECOND, StatisticKind.MAXIMUM, it.maximum()));
  }

  private void count(String figure, String words, long count) {
    add(figure, words, ONE, StatisticKind.FINAL, (double) count);
  }

  private void add(String figure, String words, String unit, StatisticKind kind, double value) {
    Measurement measurement = EventchainFactory.eINSTANCE.createMeasurement();
    measurement.setName(figure + " on " + words);
    measurement.setUnit(unit);
    measurement.setStatistic(kind);
    measurement.setValue(value);
    found.add(measurement);
  }
}

package dev.eventchain.simulation;

import dev.eventchain.documents.CsvText;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.MessageFlow;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Writes {@code measurements.csv} (RFC 4180): a row for each number of {@code measurements.json}
 * that was measured in simulated time, except series. Numbers of nodes cover all scenarios.
 */
final class MeasurementsTable {

  private static final String MILLISECOND = "ms";

  private final CsvText text = new CsvText("\r\n");

  private MeasurementsTable() {}

  /** Returns the content of the file; the chain provides the names of the latency constraints. */
  static byte[] write(SimulationResult result, EventChain chain) {
    MeasurementsTable table = new MeasurementsTable();
    table.cells(
        "scenario", "subject_kind", "subject", "name", "statistic", "value", "unit", "time_s");
    result.verdicts().forEach(verdict -> table.scenario(verdict, chain));
    result.measurements().nodes().forEach(table::node);
    table.flow("", result.measurements().flow());
    return table.text.bytes();
  }

  private void scenario(ScenarioVerdict verdict, EventChain chain) {
    String scenario = verdict.scenario();
    for (ScenarioVerdict.Figure figure : verdict.figures()) {
      String statistic = figure.statistic().name().toLowerCase(Locale.ROOT);
      Subject subject = new Subject(scenario, "signal", figure.name());
      row(subject, "value", statistic, figure.value(), figure.unit(), number(figure.time()));
    }
    for (ScenarioVerdict.CriterionResult criterion : verdict.criteria()) {
      Subject subject = new Subject(scenario, "criterion", criterion.text());
      criterion
          .margin()
          .ifPresent(
              it -> row(subject, "margin", "margin", it.value(), it.unit(), number(it.time())));
    }
    rows(new Subject(scenario, "chain", chain.getName()), "latency", verdict.latency());
    for (int i = 0; i < verdict.latencies().size(); i++) {
      String name = chain.getLatencyConstraints().get(i).getName();
      Subject subject = new Subject(scenario, "latency constraint", name);
      verdict.latencies().get(i).ifPresent(latency -> latency(subject, latency));
    }
    flow(scenario, verdict.flow());
  }

  private void flow(String scenario, MessageFlow flow) {
    flow.hops().forEach(hop -> hop(new Subject(scenario, "hop", hop.words()), hop));
    for (MessageFlow.Processing node : flow.processing()) {
      rows(new Subject(scenario, "node", node.node()), "processing", node.time());
    }
    for (MessageFlow.Topic topic : flow.topics()) {
      Subject subject = new Subject(scenario, "topic", topic.name());
      topic.published().ifPresent(published -> count(subject, "published", published));
      topic.dropped().ifPresent(dropped -> count(subject, "dropped", dropped));
      topic.lost().ifPresent(lost -> count(subject, "lost", lost));
    }
  }

  private void hop(Subject subject, MessageFlow.Hop hop) {
    rows(subject, "waiting", hop.waiting());
    rows(subject, "age", hop.age());
    hop.samples()
        .ifPresent(
            samples -> {
              count(subject, "published", samples.published());
              count(subject, "read", samples.read());
              count(subject, "neverRead", samples.neverRead());
              count(subject, "unreadAtEnd", samples.unreadAtEnd());
            });
    hop.tooOld().ifPresent(exceeded -> exceeded(subject, "tooOld", exceeded));
    hop.late().ifPresent(exceeded -> exceeded(subject, "late", exceeded));
  }

  private void exceeded(Subject subject, String name, MessageFlow.Exceeded exceeded) {
    row(subject, name, "limit", exceeded.limit(), MILLISECOND, "");
    count(subject, name, exceeded.times());
    row(subject, name, "of", (double) exceeded.of(), "1", "");
  }

  private void count(Subject subject, String name, long count) {
    row(subject, name, "count", (double) count, "1", "");
  }

  private void latency(Subject subject, ScenarioVerdict.Latency latency) {
    rows(subject, "latency", Optional.of(latency.statistics()));
    for (ScenarioVerdict.Part part : latency.slowest()) {
      row(subject, "waiting for " + part.node(), "slowest", part.waiting(), MILLISECOND, "");
      row(subject, "execution of " + part.node(), "slowest", part.execution(), MILLISECOND, "");
    }
  }

  private void node(Measurements.Node node) {
    Subject subject = new Subject("", "node", node.name());
    row(subject, "activations", "count", node.activations(), "1", "");
    rows(subject, "period", node.period());
    rows(subject, "jitter", node.jitter());
    rows(subject, "executionTime", node.executionTime());
  }

  /** Subject of a row. */
  private record Subject(String scenario, String kind, String name) {}

  private void rows(Subject subject, String name, Optional<Measurements.Statistics> values) {
    values.ifPresent(
        it -> {
          row(subject, name, "minimum", it.minimum(), MILLISECOND, "");
          row(subject, name, "mean", it.mean(), MILLISECOND, "");
          row(subject, name, "median", it.median(), MILLISECOND, "");
          row(subject, name, "percentile99", it.percentile99(), MILLISECOND, "");
          row(subject, name, "maximum", it.maximum(), MILLISECOND, "");
          row(subject, name, "count", (double) it.count(), "1", "");
        });
  }

  private void row(
      Subject of, String name, String statistic, double value, String unit, String time) {
    cells(of.scenario(), of.kind(), of.name(), name, statistic, number(value), unit, time);
  }

  /**
   * Formats a number with four decimals, as in the JSON file; NaN and infinity become an empty
   * cell.
   */
  static String number(double value) {
    if (!Double.isFinite(value)) {
      return "";
    }
    BigDecimal rounded = BigDecimal.valueOf(MeasurementsWriter.rounded(value));
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  private void cells(String... cells) {
    text.row(List.of(cells));
  }
}

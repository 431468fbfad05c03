package dev.eventchain.pipeline.measure;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.files.TextTable;
import dev.eventchain.simulation.tracing.TraceMeasurement;
import dev.eventchain.simulation.verdict.Measurements.Statistics;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Latency;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** Tables of what a trace says, for people. All times are in ms. */
final class TraceTable {

  private static final List<String> STATISTICS =
      List.of("count", "minimum", "median", "99 %", "maximum");

  private final List<List<String>> rows = new ArrayList<>();

  private TraceTable() {}

  /** Returns the tables of components, messages and latency constraints. */
  static String of(EventChain chain, TraceMeasurement measured) {
    return components(chain, measured)
        + "\n"
        + messages(measured)
        + "\n"
        + latencies(chain, measured)
        + "\n"
        + unanswered(chain, measured);
  }

  private static String components(EventChain chain, TraceMeasurement measured) {
    TraceTable table = new TraceTable();
    table.head("execution in ms", "stated");
    for (TraceMeasurement.Component each : measured.components()) {
      table.row(each.times().name(), each.times().executionTime(), worstCase(chain, each));
    }
    TraceTable periods = new TraceTable();
    periods.head("period in ms", "stated");
    for (TraceMeasurement.Component each : measured.components()) {
      periods.row(each.times().name(), each.times().period(), period(chain, each));
    }
    return table.text() + "\n" + periods.text();
  }

  private static String worstCase(EventChain chain, TraceMeasurement.Component component) {
    return node(chain, component)
        .filter(SoftwareNode::isSetWorstCaseExecutionTime)
        .map(it -> number(it.getWorstCaseExecutionTime()))
        .orElse("-");
  }

  private static String period(EventChain chain, TraceMeasurement.Component component) {
    return node(chain, component)
        .filter(it -> it.getFrequency() > 0)
        .map(it -> number(1000 / it.getFrequency()))
        .orElse("-");
  }

  private static Optional<SoftwareNode> node(
      EventChain chain, TraceMeasurement.Component component) {
    return chain.getSoftware().stream()
        .filter(it -> component.times().name().equals(it.getName()))
        .findFirst();
  }

  private static String messages(TraceMeasurement measured) {
    TraceTable table = new TraceTable();
    table.head("publication to callback in ms", "");
    for (TraceMeasurement.Hop hop : measured.hops()) {
      table.row(hop.topic() + " to " + hop.reader(), Optional.of(hop.waiting()), "");
    }
    return table.text();
  }

  private static String latencies(EventChain chain, TraceMeasurement measured) {
    TraceTable table = new TraceTable();
    table.head("latency in ms", "allowed");
    for (int i = 0; i < chain.getLatencyConstraints().size(); i++) {
      LatencyConstraint constraint = chain.getLatencyConstraints().get(i);
      String allowed = constraint.getMaximum() > 0 ? number(constraint.getMaximum()) : "-";
      table.row(
          String.valueOf(constraint.getName()),
          measured.latencies().get(i).map(Latency::statistics),
          allowed);
    }
    return table.text();
  }

  private static String unanswered(EventChain chain, TraceMeasurement measured) {
    List<List<String>> rows = new ArrayList<>();
    rows.add(List.of("never answered", "count", "ms to a later answer", "ms to the end"));
    for (int i = 0; i < chain.getLatencyConstraints().size(); i++) {
      TraceMeasurement.Unanswered found = measured.unanswered().get(i);
      rows.add(
          List.of(
              String.valueOf(chain.getLatencyConstraints().get(i).getName()),
              String.valueOf(found.count()),
              found.untilLater() > 0 ? number(found.untilLater()) : "-",
              found.untilEnd() > 0 ? number(found.untilEnd()) : "-"));
    }
    return TextTable.of(rows);
  }

  /** Returns the parts of the longest time: {@code A 5 + 1, B 8 + 2}. */
  static String parts(Latency latency) {
    return latency.slowest().stream()
        .map(it -> it.node() + " " + number(it.waiting()) + " + " + number(it.execution()))
        .collect(Collectors.joining(", "));
  }

  private static String number(double milliseconds) {
    String text = String.format(Locale.ROOT, "%.4f", milliseconds);
    return text.replaceAll("\\.?0+$", "");
  }

  private void head(String subject, String last) {
    List<String> cells = new ArrayList<>(List.of(subject));
    cells.addAll(STATISTICS);
    cells.add(last);
    rows.add(cells);
  }

  private void row(String name, Optional<Statistics> values, String last) {
    List<String> cells = new ArrayList<>(List.of(name));
    cells.addAll(
        values
            .map(
                it ->
                    List.of(
                        String.valueOf(it.count()),
                        number(it.minimum()),
                        number(it.median()),
                        number(it.percentile99()),
                        number(it.maximum())))
            .orElse(List.of("0", "-", "-", "-", "-")));
    cells.add(last);
    rows.add(cells);
  }

  private String text() {
    return TextTable.of(rows);
  }
}

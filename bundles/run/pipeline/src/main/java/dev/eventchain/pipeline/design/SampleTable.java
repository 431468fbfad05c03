package dev.eventchain.pipeline.design;

import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.verdict.Curve;
import dev.eventchain.simulation.verdict.FieldSamples;
import dev.eventchain.simulation.verdict.FieldSamples.Sample;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Values that components read and wrote around the time that decides a criterion, as a table in
 * Markdown: every message, with the numbers of the world beside it. A row holds the messages from
 * its time to the next row's; no two of one topic share a row. What never changes, and time stamps,
 * which only count as the rows do, are left out of it. What held at the nearest times at which the
 * criterion was good has rows of its own.
 */
final class SampleTable {
  private static final int MOST_ROWS = 40;
  private static final int MOST_OTHERS = 6;
  private static final double BEFORE = 0.6; // s
  private static final double AFTER = 0.2; // s
  private static final MathContext DIGITS = new MathContext(4);

  private final List<SoftwareNode> components;
  private final ScenarioVerdict verdict;
  private final List<Double> good;
  private final double decided;
  private final Map<String, NavigableMap<Double, String>> own = new LinkedHashMap<>();
  private final Map<String, NavigableMap<Double, String>> others = new LinkedHashMap<>();
  private final Map<String, String> constant = new LinkedHashMap<>();

  private SampleTable(
      List<SoftwareNode> components, ScenarioVerdict verdict, CriterionResult criterion) {
    this.components = components;
    this.verdict = verdict;
    this.good = criterion.otherwise();
    this.decided = time(verdict, criterion);
    for (SoftwareNode component : components) {
      component.getInput().forEach(it -> addOwn(component, it, "input "));
      component.getOutput().forEach(it -> addOwn(component, it, "output "));
    }
    verdict.series().curves().forEach(this::addOther);
  }

  /**
   * Returns the table.
   *
   * @param components those whose inputs and outputs are shown
   */
  static String of(
      List<SoftwareNode> components, ScenarioVerdict verdict, CriterionResult criterion) {
    return new SampleTable(components, verdict, criterion).text();
  }

  /** Returns the time that decides a criterion, in s: the end if no single one does. */
  static double time(ScenarioVerdict verdict, CriterionResult criterion) {
    List<Double> times = verdict.series().time();
    return criterion.decided().orElse(times.isEmpty() ? 0.0 : times.get(times.size() - 1));
  }

  private void addOwn(SoftwareNode component, Data data, String kind) {
    Optional<String> topic = TopicIndex.nameOf(data, component);
    verdict.samples().stream()
        .filter(
            it -> topic.equals(Optional.of(it.topic())) && it.path().equals(data.getFieldName()))
        .filter(it -> !it.path().endsWith("stamp.sec") && !it.path().endsWith("stamp.nanosec"))
        .findFirst()
        // One's output is the other's input, under the name of its topic.
        .ifPresent(it -> addOwn(it, components.size() > 1 ? signal(it) : kind + data.getName()));
  }

  private void addOwn(FieldSamples field, String name) {
    NavigableMap<Double, String> column = new TreeMap<>();
    field.samples().forEach(it -> column.put(it.time(), cell(field.form(), it)));
    Set<String> values = Set.copyOf(column.values());
    if (values.size() == 1) {
      constant.put(name, values.iterator().next() + unit(field.unit()));
    } else {
      own.put(name + unit(field.unit()), column);
    }
  }

  private static String signal(FieldSamples field) {
    return field.topic() + "." + field.path();
  }

  /** Adds a quantity of the world that changes, until there are enough. */
  private void addOther(Curve curve) {
    boolean isOfMessages =
        verdict.samples().stream().anyMatch(each -> curve.name().equals(signal(each)));
    NavigableMap<Double, String> column = new TreeMap<>();
    for (int i = 0; i < curve.values().size(); i++) {
      double value = curve.values().get(i);
      column.put(
          verdict.series().time().get(i), curve.nameOf(value).orElseGet(() -> number(value)));
    }
    boolean changes = Set.copyOf(window(column).values()).size() > 1;
    if (!isOfMessages && changes && others.size() < MOST_OTHERS) {
      others.put(curve.name() + unit(curve.unit()), column);
    }
  }

  private NavigableMap<Double, String> window(NavigableMap<Double, String> column) {
    return column.subMap(decided - BEFORE, true, decided + AFTER, true);
  }

  private static String unit(String unit) {
    return unit.isEmpty() || unit.equals("1") ? "" : " [" + unit + "]";
  }

  private static String cell(FieldSamples.Form form, Sample sample) {
    return switch (form) {
      case NUMBER -> number(sample.least());
      case TRUTH -> sample.least() != 0.0 ? "true" : "false";
      case ARRAY -> array(sample);
      case LIST -> sample.size() == 1 ? "1 element" : sample.size() + " elements";
    };
  }

  private static String array(Sample sample) {
    String count =
        sample.finite() == sample.size() || sample.finite() == 0
            ? Integer.toString(sample.size())
            : sample.finite() + " of " + sample.size();
    return sample.finite() == 0
        ? "none of " + count
        : number(sample.least()) + " to " + number(sample.most()) + " (" + count + ")";
  }

  private static String number(double value) {
    if (!Double.isFinite(value)) {
      return Double.isNaN(value) ? "-" : value > 0 ? "inf" : "-inf";
    }
    if (value == Math.rint(value) && Math.abs(value) < 1e7) {
      return Long.toString((long) value);
    }
    double size = Math.abs(value);
    return size >= 1e-4 && size < 1e7
        ? new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString()
        : String.format(Locale.ROOT, "%.3e", value);
  }

  private String text() {
    List<String> rows = rows();
    StringBuilder text = new StringBuilder("\n");
    if (rows.isEmpty()) { // Components that fall silent are what failed.
      text.append(
          String.format(
              Locale.ROOT,
              "None of these components read or wrote anything that changed from %.2f s to %.2f s.\n",
              decided - BEFORE,
              decided + AFTER));
    } else {
      addTable(text, rows);
    }
    if (!constant.isEmpty()) {
      text.append("\nThese never change: ");
      text.append(
          constant.entrySet().stream()
              .map(it -> it.getKey() + " is " + it.getValue())
              .collect(Collectors.joining(", ")));
      text.append(".\n");
    }
    return text.append('\n').toString();
  }

  private void addTable(StringBuilder text, List<String> rows) {
    List<String> names = Stream.of(own, others).flatMap(it -> it.keySet().stream()).toList();
    text.append("| time [s] | ").append(String.join(" | ", names));
    text.append(" |\n|---|").append("---|".repeat(names.size())).append('\n');
    good.stream().filter(it -> it < decided).forEach(it -> text.append(goodRow(it)));
    rows.forEach(text::append);
    good.stream().filter(it -> it > decided).forEach(it -> text.append(goodRow(it)));
  }

  /** Returns the rows around the decision, without the earliest ones of many. */
  private List<String> rows() {
    TreeSet<Double> times = new TreeSet<>();
    (own.isEmpty() ? others : own).values().forEach(it -> times.addAll(window(it).keySet()));
    List<String> rows = new ArrayList<>();
    while (!times.isEmpty()) {
      double from = times.first();
      double next = next(from);
      rows.add(row(from, next));
      times.headSet(next).clear();
    }
    return rows.subList(Math.max(0, rows.size() - MOST_ROWS), rows.size());
  }

  /**
   * Returns the first time at which the first topic has a message, with which others begin, or any
   * topic has another one; infinite without one.
   */
  private double next(double from) {
    double next = Double.POSITIVE_INFINITY;
    Collection<NavigableMap<Double, String>> columns = (own.isEmpty() ? others : own).values();
    for (NavigableMap<Double, String> column : columns) {
      boolean isFirst = column == columns.iterator().next();
      Double first = isFirst ? Double.valueOf(from) : column.ceilingKey(from);
      Double second = first == null ? null : column.higherKey(first);
      next = second == null ? next : Math.min(next, second);
    }
    return next;
  }

  private String row(double from, double next) {
    boolean decides = from <= decided && decided < next;
    List<String> cells = new ArrayList<>();
    cells.add(String.format(Locale.ROOT, "%.3f%s", from, decides ? " (decides)" : ""));
    for (NavigableMap<Double, String> column : own.values()) {
      Double time = column.ceilingKey(from);
      cells.add(time != null && time < next ? column.get(time) : "");
    }
    others.values().forEach(it -> cells.add(held(it, from)));
    return line(cells);
  }

  private String goodRow(double time) {
    List<String> cells = new ArrayList<>();
    cells.add(String.format(Locale.ROOT, "%.3f (good)", time));
    Stream.of(own, others)
        .flatMap(it -> it.values().stream())
        .forEach(it -> cells.add(held(it, time)));
    return line(cells);
  }

  private static String line(List<String> cells) {
    return "| " + String.join(" | ", cells) + " |\n";
  }

  private static String held(NavigableMap<Double, String> column, double time) {
    Map.Entry<Double, String> last = column.floorEntry(time);
    return last == null ? "" : last.getValue();
  }
}

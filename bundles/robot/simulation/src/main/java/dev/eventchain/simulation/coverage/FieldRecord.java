package dev.eventchain.simulation.coverage;

import dev.eventchain.simulation.coverage.SignalCoverage.Kind;
import dev.eventchain.simulation.formula.NamedValues;
import java.lang.reflect.Array;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;

/** The values of a signal in a scenario, or in several. */
final class FieldRecord {

  /** The fewest successive messages at rest that separate two episodes of a number. */
  private static final int REST = 5;

  private static final List<String> TRUTHS = List.of("false", "true");

  private final Kind kind;
  private final NamedValues names;
  private final double rest;
  private final SortedSet<Integer> seen = new TreeSet<>();
  private double least = Double.POSITIVE_INFINITY;
  private double most = Double.NEGATIVE_INFINITY;
  private Optional<Double> first = Optional.empty();
  private boolean away;
  private int resting;
  private boolean rested;
  private int episodes;
  private boolean any;

  /**
   * Creates an empty record.
   *
   * @param names the names of its values; none unless it has named ones
   * @param rest the number at rest
   */
  FieldRecord(Kind kind, NamedValues names, double rest) {
    this.kind = kind;
    this.names = names;
    this.rest = rest;
  }

  /** Adds the value of a message. */
  void add(Object value) {
    any = true;
    switch (kind) {
      case LIST -> extend(size(value));
      case TRUTH -> addTruth((Boolean) value);
      case NAMED -> addNamed(value);
      case NUMBER -> addNumber(((Number) value).doubleValue());
    }
  }

  /** Adds an element of an array; 1 and 0 for Booleans. */
  void addElement(double element) {
    add(kind == Kind.TRUTH ? (Object) (element != 0.0) : (Object) element);
  }

  private static int size(Object list) {
    return list instanceof Collection<?> elements ? elements.size() : Array.getLength(list);
  }

  private void extend(double value) {
    if (Double.isFinite(value)) {
      least = Math.min(least, value);
      most = Math.max(most, value);
    }
  }

  private void addTruth(boolean truth) {
    seen.add(truth ? 1 : 0);
    follow(truth, 1);
  }

  private void addNamed(Object value) {
    double number =
        names.isText() ? names.numberOf(String.valueOf(value)) : ((Number) value).doubleValue();
    names.namesOf(number).forEach(name -> seen.add(names.names().indexOf(name)));
    first = first.or(() -> Optional.of(number));
    follow(number != first.get(), 1);
  }

  private void addNumber(double value) {
    extend(value);
    follow(value != rest, REST);
  }

  /** Follows times away from rest, which a number of messages at rest have to separate. */
  private void follow(boolean isAway, int between) {
    if (isAway && !away && (resting >= between || episodes == 0)) {
      episodes++;
    }
    resting = isAway ? 0 : Math.min(between, resting + 1);
    rested |= resting >= between;
    away = isAway;
  }

  /** Adds what another scenario has shown. */
  void add(FieldRecord other) {
    any |= other.any;
    seen.addAll(other.seen);
    extend(other.least);
    extend(other.most);
    rested |= other.rested;
    episodes = Math.max(episodes, other.episodes);
  }

  /** Returns whether there was a value. */
  boolean hasAny() {
    return any;
  }

  /** Returns what was recorded of a signal. */
  SignalCoverage coverage(String topic, String path, String unit, String writer) {
    List<String> all = kind == Kind.TRUTH ? TRUTHS : names.names();
    boolean follows = rested && !path.contains("[]");
    return new SignalCoverage(
        topic,
        path,
        unit,
        kind,
        writer,
        least <= most ? least : Double.NaN,
        least <= most ? most : Double.NaN,
        seen.stream().map(all::get).toList(),
        all.stream().filter(each -> !seen.contains(all.indexOf(each))).toList(),
        follows ? episodes : 0,
        List.of());
  }
}

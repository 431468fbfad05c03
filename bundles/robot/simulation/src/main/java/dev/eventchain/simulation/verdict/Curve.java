package dev.eventchain.simulation.verdict;

import java.util.List;
import java.util.Optional;

/**
 * A quantity over time.
 *
 * @param name of the quantity
 * @param unit of the values; 1 for a ratio
 * @param absence why it has no values; empty if it has some
 * @param values one for each time of the series, infinite or NaN where there is none
 * @param names the names of values, if they have any
 */
public record Curve(
    String name, String unit, String absence, List<Double> values, List<Name> names) {

  /** A value with a name. */
  public record Name(double value, String name) {}

  /** Copies the lists. */
  public Curve {
    values = List.copyOf(values);
    names = List.copyOf(names);
  }

  /** Creates a curve of plain numbers. */
  public Curve(String name, String unit, String absence, List<Double> values) {
    this(name, unit, absence, values, List.of());
  }

  /** Returns the name of a value. */
  public Optional<String> nameOf(double value) {
    return names.stream()
        .filter(each -> Math.abs(each.value() - value) <= 1e-6 * Math.max(1.0, Math.abs(value)))
        .map(Name::name)
        .findFirst();
  }
}

package dev.eventchain.simulation.formula;

import dev.eventchain.simulation.verdict.Curve;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * The names of a signal's values: those of numbers, or texts, for which their positions stand.
 *
 * @param values the values with names, in the unit of the signal; several may have one name
 * @param isText whether the signal is a text, so that its numbers mean nothing by themselves
 */
public record NamedValues(List<Value> values, boolean isText) {

  /** A number with a name. */
  public record Value(String name, double number) {}

  /** No names. */
  public static final NamedValues NONE = new NamedValues(List.of(), false);

  /** The number of a text that is none of those known. */
  private static final double OTHER = -1.0;

  /** Copies the list. */
  public NamedValues {
    values = List.copyOf(values);
  }

  /** Returns the values of a signal that is one of some texts. */
  public static NamedValues ofTexts(List<String> texts) {
    return new NamedValues(
        IntStream.range(0, texts.size()).mapToObj(i -> new Value(texts.get(i), i)).toList(), true);
  }

  /** Returns the names of values that are numbers. */
  public static NamedValues ofNumbers(List<Value> values) {
    return new NamedValues(values, false);
  }

  /** Returns whether no value has a name. */
  public boolean isEmpty() {
    return values.isEmpty();
  }

  /** Returns the names, each once. */
  public List<String> names() {
    return values.stream().map(Value::name).distinct().toList();
  }

  /** Returns the number that stands for a text. */
  public double numberOf(String text) {
    OptionalDouble found =
        values.stream().filter(it -> it.name().equals(text)).mapToDouble(Value::number).findFirst();
    return found.orElse(OTHER);
  }

  /** Returns the first name of a number, in the unit of the signal. */
  public Optional<String> nameOf(double number) {
    return namesOf(number).stream().findFirst();
  }

  /** Returns the names of a number, in the unit of the signal; constants may have one number. */
  public List<String> namesOf(double number) {
    return Curve.at(number, values, Value::number).stream().map(Value::name).toList();
  }

  /** Returns whether a number, in the unit of the signal, has a name, which others may have too. */
  boolean isNamed(double number, String name) {
    return namesOf(number).contains(name);
  }

  /** Returns all numbers with names, and one without: even a text may be none of those known. */
  double[] tried() {
    return DoubleStream.concat(
            values.stream().mapToDouble(Value::number).distinct(),
            DoubleStream.of(Double.MAX_VALUE))
        .toArray();
  }
}

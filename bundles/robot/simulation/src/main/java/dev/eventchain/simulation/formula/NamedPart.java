package dev.eventchain.simulation.formula;

import dev.eventchain.messages.Unit;
import java.util.Objects;
import java.util.Set;
import java.util.function.IntToDoubleFunction;

/** The truth that a signal has a named value, as a quantity: 1 or 0. */
final class NamedPart {

  private final Signal signal;
  private final String name;

  NamedPart(Signal signal, String name) {
    this.signal = signal;
    this.name = name;
  }

  Signal signal() {
    return signal;
  }

  /** Returns 1 where the signal has the value, 0 where it has another one, NaN without one. */
  Term term() {
    Term.Values values =
        run -> {
          IntToDoubleFunction all = Term.of(signal).values().in(run);
          return sample -> {
            double value = all.applyAsDouble(sample);
            return Double.isNaN(value) ? value : of(signal.inUnit(value));
          };
        };
    Unit one = Unit.parse("1").orElseThrow();
    return new Term(
        one, "1", true, Set.of(signal), values, Sum.of(this, ranges -> Range.upTo(1.0)));
  }

  /** Returns 1 for the value, in the unit of the signal, and 0 for all others. */
  double of(double value) {
    return signal.named().isNamed(value, name) ? 1.0 : 0.0;
  }

  /** Returns what the signal is at a sample, in words; empty if the comparison says it. */
  String found(SampledRun run, int sample) {
    double value = signal.inUnit(run.of(signal)[sample]);
    if (Double.isNaN(value) || of(value) == 1.0) {
      return "";
    }
    return signal
        .named()
        .nameOf(value)
        .map(it -> ", where it is '" + it + "'")
        .orElse(
            signal.named().isText()
                ? ", where it is another text"
                : ", where it is " + plain(value));
  }

  private static String plain(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof NamedPart that
        && that.signal.name().equals(signal.name())
        && that.name.equals(name);
  }

  @Override
  public int hashCode() {
    return Objects.hash(signal.name(), name);
  }
}

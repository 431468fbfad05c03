package dev.eventchain.openscenario.storyboard.scene;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Named values: parameters or variables. */
public final class Values {

  private final Map<String, String> values = new LinkedHashMap<>();

  /** Gives a name a value. */
  public void set(String name, String value) {
    values.put(name, value);
  }

  /** Returns the value of a name that has one. */
  public String get(String name) {
    return values.get(name);
  }

  /** Returns the names and values, in their order. */
  public Map<String, String> all() {
    return Map.copyOf(values);
  }

  /** Adds to a number. */
  public void add(String name, double value) {
    number(name).ifPresent(before -> set(name, text(before + value)));
  }

  /** Multiplies a number. */
  public void multiply(String name, double value) {
    number(name).ifPresent(before -> set(name, text(before * value)));
  }

  /** Returns the value of a name as a number; empty if it is none. */
  public Optional<Double> number(String name) {
    return parsed(values.get(name));
  }

  /** Returns a text as a number; empty if it is none. */
  public static Optional<Double> parsed(String text) {
    try {
      return Optional.of(Double.valueOf(text));
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** Returns a number as text, without an exponent or a fraction of zeros. */
  private static String text(double value) {
    return Double.isFinite(value)
        ? new BigDecimal(Double.toString(value)).stripTrailingZeros().toPlainString()
        : Double.toString(value);
  }
}

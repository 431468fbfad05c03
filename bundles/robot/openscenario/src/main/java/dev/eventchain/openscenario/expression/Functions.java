package dev.eventchain.openscenario.expression;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;

/**
 * The functions of expressions. They come from {@link StrictMath}, so that each machine has the
 * same values.
 */
final class Functions {

  static final Map<String, DoubleUnaryOperator> OF_ONE =
      new TreeMap<>(
          Map.ofEntries(
              Map.entry("abs", Math::abs),
              Map.entry("acos", StrictMath::acos),
              Map.entry("asin", StrictMath::asin),
              Map.entry("atan", StrictMath::atan),
              Map.entry("ceil", Math::ceil),
              Map.entry("cos", StrictMath::cos),
              Map.entry("floor", Math::floor),
              Map.entry("round", Functions::round),
              Map.entry("sign", Math::signum),
              Map.entry("sin", StrictMath::sin),
              Map.entry("sqrt", Math::sqrt),
              Map.entry("tan", StrictMath::tan)));

  static final Map<String, DoubleBinaryOperator> OF_TWO =
      new TreeMap<>(Map.of("max", Math::max, "min", Math::min, "pow", StrictMath::pow));

  private static final double HALF = 0.5;

  private Functions() {}

  /** Rounds halves away from zero, as C does. */
  private static double round(double value) {
    double below = Math.floor(Math.abs(value));
    double rounded = Math.abs(value) - below >= HALF ? below + 1 : below;
    return Math.copySign(rounded, value);
  }
}

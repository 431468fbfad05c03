package dev.eventchain.pipeline.simulate;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/** Rounding of numbers in results. */
final class Rounding {

  /** Four decimals are enough for display, and keep the page small. */
  private static final double FINEST = 1e4;

  private static final double CENTIMETRES = 1e2;

  private Rounding() {}

  static double rounded(double value) {
    return Math.round(value * FINEST) / FINEST;
  }

  static OptionalDouble rounded(OptionalDouble value) {
    return value.stream().map(Rounding::rounded).findFirst();
  }

  /** Returns rounded values; null for those that are not finite. */
  static List<Double> rounded(List<Double> values) {
    return rounded(values, FINEST);
  }

  /** Returns lengths in metres, rounded to centimetres; null for those that are not finite. */
  static List<Double> toCentimetres(List<Double> values) {
    return rounded(values, CENTIMETRES);
  }

  private static List<Double> rounded(List<Double> values, double parts) {
    List<Double> rounded = new ArrayList<>();
    for (double value : values) {
      rounded.add(Double.isFinite(value) ? (Double) (Math.round(value * parts) / parts) : null);
    }
    return rounded;
  }
}

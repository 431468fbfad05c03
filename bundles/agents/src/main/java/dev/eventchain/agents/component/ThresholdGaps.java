package dev.eventchain.agents.component;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;

/** Values just below, at and just above a threshold of an input that no test has. */
final class ThresholdGaps {

  /** Maximal relative distance of a test from a threshold. */
  private static final double NEAR = 0.1;

  private static final double SAME = 1e-9;

  private static final String DISTANCE = ", by at most ";

  /** The least and the greatest values of short whole numbers. */
  private static final Map<String, double[]> RANGES =
      Map.of(
          "int8", new double[] {-128, 127},
          "uint8", new double[] {0, 255},
          "byte", new double[] {0, 255},
          "octet", new double[] {0, 255},
          "char", new double[] {0, 255},
          "int16", new double[] {-32768, 32767},
          "uint16", new double[] {0, 65535},
          "uint32", new double[] {0, Double.MAX_VALUE},
          "uint64", new double[] {0, Double.MAX_VALUE});

  private final String type;
  private final double bound;
  private final double reach;
  private final double least;
  private final double most;

  /**
   * Creates the gaps at a threshold.
   *
   * @param type the type of the input
   * @param bounds all thresholds of the input; near 0, the largest one says what is near
   */
  ThresholdGaps(String type, double bound, Collection<Double> bounds) {
    this.type = type;
    this.bound = bound;
    double size = Math.abs(bound);
    if (size < SAME) {
      double largest = bounds.stream().mapToDouble(Math::abs).max().orElse(0);
      size = largest < SAME ? 1 / NEAR : largest;
    }
    double[] range = RANGES.getOrDefault(type, new double[] {-Double.MAX_VALUE, Double.MAX_VALUE});
    this.least = range[0];
    this.most = range[1];
    this.reach = isWhole(type) ? Math.max(size * NEAR, 1) : size * NEAR;
  }

  /** Returns whether a type holds whole numbers only. */
  static boolean isWhole(String type) {
    return RANGES.containsKey(type) || type.equals("int32") || type.equals("int64");
  }

  /** Returns the gaps that values of tests leave, in words. */
  List<String> in(List<Double> values, String input) {
    double same = Math.max(Math.abs(bound) * SAME, SAME);
    List<String> missing = new ArrayList<>();
    if (bound > least
        && bound - reach <= most
        && values.stream().noneMatch(v -> v < bound - same && isNear(v))) {
      missing.add("with '%s' just below %s%s".formatted(input, bound, distance()));
    }
    if (isPossible() && values.stream().noneMatch(v -> Math.abs(v - bound) <= same)) {
      missing.add("with '%s' at %s".formatted(input, bound));
    }
    if (bound < most
        && bound + reach >= least
        && values.stream().noneMatch(v -> v > bound + same && isNear(v))) {
      missing.add("with '%s' just above %s%s".formatted(input, bound, distance()));
    }
    return missing;
  }

  private boolean isNear(double value) {
    return Math.abs(value - bound) <= reach + SAME;
  }

  private boolean isPossible() {
    return !isWhole(type) || (bound == Math.rint(bound) && bound >= least && bound <= most);
  }

  /** Returns whether a gap in words says how near a value has to be. */
  static boolean statesDistance(String gap) {
    return gap.contains(DISTANCE);
  }

  /** Returns the distance in words where it is not a tenth of the threshold. */
  private String distance() {
    return reach > Math.abs(bound) * NEAR + SAME ? DISTANCE + reach : "";
  }
}

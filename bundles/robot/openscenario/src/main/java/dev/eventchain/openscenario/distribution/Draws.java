package dev.eventchain.openscenario.distribution;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleSupplier;

/**
 * Random draws. {@link Random} is used since its numbers are specified; what is computed with them
 * is exact, or comes from {@link StrictMath}.
 */
public final class Draws {

  private static final int MOST_TRIES = 10_000;

  /** The largest mean whose exponential is far from zero. */
  private static final double LARGEST_STEP = 500;

  /** The odd number next to 2^64 divided by the golden ratio, as in SplitMix64. */
  private static final long STEP = 0x9E3779B97F4A7C15L;

  private static final long FIRST_FACTOR = 0xBF58476D1CE4E5B9L;
  private static final long SECOND_FACTOR = 0x94D049BB133111EBL;

  private Draws() {}

  /**
   * Returns the random numbers of one parameter, which do not depend on the other parameters of a
   * file.
   *
   * @param seed the seed of the file
   */
  public static Random of(double seed, String parameter) {
    long bits = Double.doubleToLongBits(seed + 0.0) + STEP * parameter.hashCode();
    bits = (bits ^ (bits >>> 30)) * FIRST_FACTOR;
    bits = (bits ^ (bits >>> 27)) * SECOND_FACTOR;
    return new Random(bits ^ (bits >>> 31));
  }

  /** Returns an index, each with the probability of its weight. */
  static int index(List<Double> weights, Random random) {
    double sum = 0;
    for (double weight : weights) {
      sum += weight;
    }
    double rest = random.nextDouble() * sum;
    int last = 0;
    for (int i = 0; i < weights.size(); i++) {
      if (weights.get(i) > 0) {
        last = i;
        rest -= weights.get(i);
        if (rest < 0) {
          return i;
        }
      }
    }
    return last;
  }

  /** Draws until a value is within limits; empty if that takes too long. */
  static Optional<Double> within(Limits limits, DoubleSupplier draw) {
    for (int i = 0; i < MOST_TRIES; i++) {
      double value = draw.getAsDouble();
      if (limits.contain(value) && Double.isFinite(value)) {
        return Optional.of(value);
      }
    }
    return Optional.empty();
  }

  /** Draws a Poisson distributed count by Knuth's method, in steps for a large mean. */
  static double count(double mean, Random random) {
    double count = 0;
    for (double rest = mean; rest > 0; rest -= LARGEST_STEP) {
      double end = StrictMath.exp(-Math.min(rest, LARGEST_STEP));
      for (double product = random.nextDouble(); product > end; product *= random.nextDouble()) {
        count++;
      }
    }
    return count;
  }
}

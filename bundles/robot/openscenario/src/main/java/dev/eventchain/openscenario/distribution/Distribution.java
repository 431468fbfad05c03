package dev.eventchain.openscenario.distribution;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/** A distribution of values of one parameter. */
public sealed interface Distribution {

  /**
   * Draws a value.
   *
   * @param random the numbers to make it from
   * @return the value as text; empty if none was within the limits in thousands of draws
   */
  Optional<String> draw(Random random);

  /** A value of a list, each with its weight. */
  record Weighted(List<String> values, List<Double> weights) implements Distribution {

    /** Copies the lists. */
    public Weighted {
      values = List.copyOf(values);
      weights = List.copyOf(weights);
    }

    @Override
    public Optional<String> draw(Random random) {
      return Optional.of(values.get(Draws.index(weights, random)));
    }
  }

  /** A number of one of several ranges, each with its weight and even in itself. */
  record Histogram(List<Limits> bins, List<Double> weights) implements Distribution {

    /** Copies the lists. */
    public Histogram {
      bins = List.copyOf(bins);
      weights = List.copyOf(weights);
    }

    /** Returns a distribution that is even within a range. */
    public static Histogram uniform(Limits range) {
      return new Histogram(List.of(range), Collections.nCopies(1, 1.0));
    }

    @Override
    public Optional<String> draw(Random random) {
      Limits bin = bins.get(Draws.index(weights, random));
      double part = random.nextDouble();
      return Optional.of(Double.toString(bin.lower() * (1 - part) + bin.upper() * part));
    }
  }

  /** A normally distributed number within limits. */
  record Normal(double mean, double variance, Limits limits) implements Distribution {

    @Override
    public Optional<String> draw(Random random) {
      double deviation = Math.sqrt(variance);
      return Draws.within(limits, () -> mean + deviation * random.nextGaussian())
          .map(value -> Double.toString(value));
    }
  }

  /**
   * A number within limits whose logarithm is normally distributed.
   *
   * @param mean the mean of the number itself, not of its logarithm; positive
   * @param variance the variance likewise
   */
  record LogNormal(double mean, double variance, Limits limits) implements Distribution {

    @Override
    public Optional<String> draw(Random random) {
      double square = StrictMath.log(1 + variance / (mean * mean));
      double middle = StrictMath.log(mean) - square / 2;
      double deviation = Math.sqrt(square);
      return Draws.within(limits, () -> StrictMath.exp(middle + deviation * random.nextGaussian()))
          .map(value -> Double.toString(value));
    }
  }

  /** A count within limits, of events that come independently of each other. */
  record Poisson(double mean, Limits limits) implements Distribution {

    @Override
    public Optional<String> draw(Random random) {
      return Draws.within(limits, () -> Draws.count(mean, random))
          .map(value -> Long.toString(Math.round(value)));
    }
  }
}

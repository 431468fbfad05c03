package dev.eventchain.pipeline.search;

import java.util.Arrays;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxEval;
import org.hipparchus.optim.SimpleBounds;
import org.hipparchus.optim.nonlinear.scalar.GoalType;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.scalar.noderiv.CMAESOptimizer;
import org.hipparchus.random.Well19937c;

/** Choice of the next point of the unit cube. */
public enum SearchMethod {
  /**
   * Evolution with an adapted covariance matrix (N. Hansen, The CMA Evolution Strategy: A Tutorial,
   * 2016): draws around a mean, which moves, as the shape of what is drawn does, with the better
   * half of each generation. It reads the order of the values only.
   */
  CMA_ES {
    @Override
    void run(ToDoubleFunction<double[]> function, double[] start, SplittableRandom random) {
      int dimensions = start.length;
      new CMAESOptimizer(
              Integer.MAX_VALUE,
              0, // no value is small enough
              true,
              0,
              0,
              new Well19937c(random.nextLong()),
              false,
              null)
          .optimize(
              new MaxEval(Integer.MAX_VALUE),
              new ObjectiveFunction(function::applyAsDouble),
              GoalType.MINIMIZE,
              new InitialGuess(start),
              new SimpleBounds(filled(dimensions, 0), filled(dimensions, Math.nextDown(1.0))),
              new CMAESOptimizer.Sigma(filled(dimensions, FIRST_WIDTH)),
              new CMAESOptimizer.PopulationSize(4 + (int) (3 * Math.log(dimensions))));
    }
  },

  /** Independent draws, all places with the same probability. */
  RANDOM {
    @Override
    void run(ToDoubleFunction<double[]> function, double[] start, SplittableRandom random) {
      double value;
      do { // The function has an end.
        value = function.applyAsDouble(random.doubles(start.length).toArray());
      } while (!Double.isNaN(value));
    }
  };

  /** Standard deviation of the first generation: the cube, but for its other end. */
  private static final double FIRST_WIDTH = 0.25;

  private static double[] filled(int dimensions, double value) {
    double[] values = new double[dimensions];
    Arrays.fill(values, value);
    return values;
  }

  /** Returns its name in files. */
  public String key() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Asks for values of a function until nothing better is to be expected, or the function ends it
   * by an exception.
   *
   * @param start where it begins
   */
  abstract void run(ToDoubleFunction<double[]> function, double[] start, SplittableRandom random);
}

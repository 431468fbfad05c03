package dev.eventchain.roads.geometry;

import java.util.function.DoubleUnaryOperator;

/** Integration by Gauss and Legendre with eight nodes, exact for polynomials of degree 15. */
public final class Quadrature {

  private static final double[] NODES = {
    0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363
  };
  private static final double[] WEIGHTS = {
    0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763
  };

  private Quadrature() {}

  /** Returns the integral of a smooth function over one interval. */
  public static double integral(DoubleUnaryOperator function, double from, double to) {
    double middle = (from + to) / 2;
    double half = (to - from) / 2;
    double sum = 0;
    for (int i = 0; i < NODES.length; i++) {
      double step = half * NODES[i];
      sum +=
          WEIGHTS[i]
              * (function.applyAsDouble(middle - step) + function.applyAsDouble(middle + step));
    }
    return sum * half;
  }
}

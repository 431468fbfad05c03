package dev.eventchain.roads.geo;

/**
 * The transverse Mercator projection of the ellipsoid of WGS 84, by Krüger's series to the sixth
 * order of the third flattening (C. Karney, Transverse Mercator with an accuracy of a few
 * nanometers, 2011): exact to rounding within some 4,000 km of the central meridian.
 */
final class TransverseMercator {

  private static final double RADIUS = 6_378_137.0;
  private static final double FLATTENING = 1 / 298.257223563;
  private static final double N = FLATTENING / (2 - FLATTENING);
  private static final double ECCENTRICITY = StrictMath.sqrt(FLATTENING * (2 - FLATTENING));

  /** Coefficients of the series: those of order k, of its powers of n from the kth on. */
  private static final double[][] SERIES = {
    {1 / 2.0, -2 / 3.0, 5 / 16.0, 41 / 180.0, -127 / 288.0, 7891 / 37800.0},
    {13 / 48.0, -3 / 5.0, 557 / 1440.0, 281 / 630.0, -1983433 / 1935360.0},
    {61 / 240.0, -103 / 140.0, 15061 / 26880.0, 167603 / 181440.0},
    {49561 / 161280.0, -179 / 168.0, 6601661 / 7257600.0},
    {34729 / 80640.0, -3418889 / 1995840.0},
    {212378941 / 319334400.0},
  };

  /** Radius of the sphere on which the meridians are as long, in m. */
  private static final double RECTIFYING =
      RADIUS / (1 + N) * (1 + N * N / 4 + pow(N, 4) / 64 + pow(N, 6) / 256);

  private static final double[] ALPHA = alpha();

  private TransverseMercator() {}

  private static double pow(double base, int exponent) {
    double power = 1;
    for (int i = 0; i < exponent; i++) {
      power *= base;
    }
    return power;
  }

  private static double[] alpha() {
    double[] alpha = new double[SERIES.length];
    for (int order = 0; order < alpha.length; order++) {
      for (int i = 0; i < SERIES[order].length; i++) {
        alpha[order] += SERIES[order][i] * pow(N, order + 1 + i);
      }
    }
    return alpha;
  }

  /**
   * Returns how far a place is to the east of the central meridian and to the north of the equator,
   * in m, at scale 1.
   *
   * @param latitude in rad
   * @param longitude from the central meridian, in rad
   */
  static double[] project(double latitude, double longitude) {
    double sine = StrictMath.sin(latitude);
    double isometric = StrictMath.sinh(artanh(sine) - ECCENTRICITY * artanh(ECCENTRICITY * sine));
    double xi = StrictMath.atan2(isometric, StrictMath.cos(longitude));
    double eta =
        arsinh(StrictMath.sin(longitude) / StrictMath.hypot(isometric, StrictMath.cos(longitude)));
    double north = xi;
    double east = eta;
    for (int i = 0; i < ALPHA.length; i++) {
      double factor = 2.0 * (i + 1);
      north += ALPHA[i] * StrictMath.sin(factor * xi) * StrictMath.cosh(factor * eta);
      east += ALPHA[i] * StrictMath.cos(factor * xi) * StrictMath.sinh(factor * eta);
    }
    return new double[] {RECTIFYING * east, RECTIFYING * north};
  }

  private static double artanh(double x) {
    return (StrictMath.log1p(x) - StrictMath.log1p(-x)) / 2;
  }

  private static double arsinh(double x) {
    return StrictMath.copySign(
        StrictMath.log1p(Math.abs(x) + x * x / (1 + StrictMath.hypot(1, x))), x);
  }
}

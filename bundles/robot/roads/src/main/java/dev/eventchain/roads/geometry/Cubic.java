package dev.eventchain.roads.geometry;

/** The polynomial {@code a + b u + c u² + d u³}. */
public record Cubic(double a, double b, double c, double d) {

  boolean isZero() {
    return a == 0 && b == 0 && c == 0 && d == 0;
  }

  /**
   * Returns a value or derivative.
   *
   * @param order 0 for the value, 1 to 3 for a derivative
   */
  public double at(double u, int order) {
    return switch (order) {
      case 0 -> a + u * (b + u * (c + u * d));
      case 1 -> b + u * (2 * c + u * 3 * d);
      case 2 -> 2 * c + 6 * d * u;
      default -> 6 * d;
    };
  }
}

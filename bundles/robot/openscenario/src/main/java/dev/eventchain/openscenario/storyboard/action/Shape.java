package dev.eventchain.openscenario.storyboard.action;

/**
 * The shape of a transition from 0 to 1. Its slope is largest in the middle, and its mean is one
 * half.
 */
enum Shape {
  STEP,
  LINEAR,
  CUBIC,
  SINUSOIDAL;

  static Shape of(String text) {
    return switch (text) {
      case "step" -> STEP;
      case "linear" -> LINEAR;
      case "cubic" -> CUBIC;
      case "sinusoidal" -> SINUSOIDAL;
      default -> throw new IllegalArgumentException(text);
    };
  }

  /** Returns the value at a part of the way, from 0 to 1. */
  double value(double part) {
    return switch (this) {
      case STEP -> 1;
      case LINEAR -> part;
      case CUBIC -> part * part * (3 - 2 * part);
      case SINUSOIDAL -> (1 - StrictMath.cos(Math.PI * part)) / 2;
    };
  }

  /** Returns the slope there. */
  double slope(double part) {
    return switch (this) {
      case STEP -> 0;
      case LINEAR -> 1;
      case CUBIC -> 6 * part * (1 - part);
      case SINUSOIDAL -> Math.PI / 2 * StrictMath.sin(Math.PI * part);
    };
  }

  /** Returns the integral from 0 to there. */
  double integral(double part) {
    return switch (this) {
      case STEP -> part;
      case LINEAR -> part * part / 2;
      case CUBIC -> part * part * part * (1 - part / 2);
      case SINUSOIDAL -> (part - StrictMath.sin(Math.PI * part) / Math.PI) / 2;
    };
  }

  /** Returns the largest slope. */
  double steepest() {
    return switch (this) {
      case STEP -> Double.POSITIVE_INFINITY;
      case LINEAR -> 1;
      case CUBIC -> 1.5;
      case SINUSOIDAL -> Math.PI / 2;
    };
  }

  /**
   * Returns the largest curvature; for a line the least that a way of the same duration needs,
   * which accelerates for half of it and brakes for the other half.
   */
  double sharpest() {
    return switch (this) {
      case STEP -> Double.POSITIVE_INFINITY;
      case LINEAR -> 4;
      case CUBIC -> 6;
      case SINUSOIDAL -> Math.PI * Math.PI / 2;
    };
  }
}

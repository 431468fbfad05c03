package dev.eventchain.roads.geometry;

import java.util.Arrays;
import java.util.List;

/** A function of s made of cubic polynomials, each from its start to that of the next. */
public final class Profile {

  /** The constant 0. */
  public static final Profile ZERO = new Profile(List.of());

  /** Difference between numbers of a file that are meant to be equal, in m. */
  public static final double ROUNDING = 1e-3;

  private final double[] starts;
  private final Cubic[] pieces;
  private final boolean zero;

  /**
   * A polynomial from a place on.
   *
   * @param start the place, at which the polynomial's argument is 0
   */
  public record Piece(double start, Cubic cubic) {}

  /**
   * Creates a function, which is 0 before its first piece.
   *
   * @param pieces in ascending order of their starts
   */
  public Profile(List<Piece> pieces) {
    // No streams: there are several for each lane of a map, and setting one up takes longer.
    this.starts = new double[pieces.size()];
    this.pieces = new Cubic[pieces.size()];
    boolean allZero = true;
    for (int i = 0; i < starts.length; i++) {
      Piece piece = pieces.get(i);
      starts[i] = piece.start();
      this.pieces[i] = piece.cubic();
      allZero &= piece.cubic().isZero();
    }
    this.zero = allZero;
  }

  /** Returns whether it is 0 everywhere. */
  public boolean isZero() {
    return zero;
  }

  /** Returns the starts of the pieces. */
  public double[] starts() {
    return starts.clone();
  }

  /** Returns the value. */
  public double at(double s) {
    return at(s, 0);
  }

  /** Returns the value, or a derivative of an order up to 3. */
  public double at(double s, int order) {
    int i = indexAt(starts, s + (starts.length > 0 && s < starts[0] ? ROUNDING : 0));
    return i < 0 ? 0 : pieces[i].at(s - starts[i], order);
  }

  /** Returns the index of the last start that is not behind a place; -1 before the first one. */
  public static int indexAt(double[] starts, double s) {
    int found = Arrays.binarySearch(starts, s);
    if (found < 0) {
      return -found - 2;
    }
    while (found + 1 < starts.length && starts[found + 1] <= s) {
      found++;
    }
    return found;
  }
}

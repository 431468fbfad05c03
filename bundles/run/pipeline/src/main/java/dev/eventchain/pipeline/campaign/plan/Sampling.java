package dev.eventchain.pipeline.campaign.plan;

import java.util.Locale;

/**
 * Choice of the combinations of the factors' values that are simulated.
 *
 * @param cases how many; 0 for those that follow from the values
 */
public record Sampling(Kind kind, int cases) {

  public enum Kind {
    /** All combinations. */
    GRID,
    /** The rows of a table. */
    ROWS,
    /** Combinations in which any two values of two factors occur together. */
    PAIRS,
    /** Independent draws. */
    RANDOM,
    /** Draws that fill the range of each factor evenly. */
    LATIN_HYPERCUBE,
    /** A sequence of low discrepancy. */
    HALTON;

    String key() {
      return name().toLowerCase(Locale.ROOT);
    }

    /** Returns whether the number of cases has to be given. */
    boolean isDrawn() {
      return compareTo(PAIRS) > 0;
    }
  }

  public static final Sampling USUAL = new Sampling(Kind.GRID, 0);
}

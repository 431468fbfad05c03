package dev.eventchain.simulation.formula;

/**
 * An interval relative to a sample, in samples; both ends are included.
 *
 * @param to not before {@code from}; unused without a bound
 * @param bounded true if it has an upper bound
 */
record Interval(int from, int to, boolean bounded) {

  /** From a sample to the end of the run. */
  static final Interval ALL = new Interval(0, 0, false);

  /**
   * Returns the last sample of the interval after any sample up to one, in a run of a given size.
   */
  int last(int latest, int size) {
    return bounded ? Math.min(latest + to, size - 1) : size - 1;
  }
}

package dev.eventchain.simulation.formula;

/**
 * An interval after a sample, in samples; both ends belong to it.
 *
 * @param to not before {@code from}; unused without a bound
 * @param bounded whether it ends before the run does
 */
record Interval(int from, int to, boolean bounded) {

  /** From now to the end of the run. */
  static final Interval ALL = new Interval(0, 0, false);

  /** The last sample that belongs to it after any up to one, in a run of a size. */
  int last(int latest, int size) {
    return bounded ? Math.min(latest + to, size - 1) : size - 1;
  }
}

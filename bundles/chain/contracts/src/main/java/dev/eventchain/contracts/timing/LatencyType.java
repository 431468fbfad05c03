package dev.eventchain.contracts.timing;

/** The two end-to-end times of timing analysis. */
public enum LatencyType {
  /**
   * Maximum reaction time: from an event that the first task has just missed to the end of the
   * first execution of the last task that is based on it or on a later one.
   */
  REACTION,
  /**
   * Reduced maximum data age: from the start of the first task to the end of any execution of the
   * last task that is still based on what was read then.
   */
  DATA_AGE
}

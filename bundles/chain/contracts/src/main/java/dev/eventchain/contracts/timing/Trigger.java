package dev.eventchain.contracts.timing;

/** Cause of a task's activations, and when it reads and writes. */
public enum Trigger {
  /** A timer. Reads when it starts to execute, writes when it has ended. */
  PERIODIC,
  /** Logical execution time: reads at its release, writes at the end of a fixed interval. */
  LOGICAL,
  /** Each message of the task before it. */
  MESSAGE,
  /** Events of its own, of which only the longest separation may be known. */
  SPORADIC
}

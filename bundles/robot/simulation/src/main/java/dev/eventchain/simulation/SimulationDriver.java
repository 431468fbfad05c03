package dev.eventchain.simulation;

/** What brings messages from one to another, and lets time pass. */
public enum SimulationDriver {
  /** All nodes in one process, messages in memory. */
  LOCKSTEP("lock-step"),
  /**
   * Each node in its own process on Cyclone DDS, in simulated time. Faults that kill or stop a node
   * act within its host, at an instant of simulated time, so that they do the same as in lock-step;
   * the host itself continues.
   */
  DDS("Cyclone DDS in simulated time"),
  /** The same in real time: one scenario after the other, and no node waits for another. */
  DDS_IN_REAL_TIME("Cyclone DDS in real time"),
  /** No node is started here: others run them, in real time. */
  DDS_ATTACHED("Cyclone DDS, attached");

  private final String words;

  SimulationDriver(String words) {
    this.words = words;
  }

  /** For people: what it is. */
  public String words() {
    return words;
  }
}

package dev.eventchain.simulation;

/** Driver of the nodes: transports messages and advances time. */
public enum SimulationDriver {
  /** All nodes in one process, messages in memory. */
  LOCKSTEP("lock-step"),
  /**
   * Each node in its own process on Cyclone DDS, in simulated time. Faults that kill or stop a node
   * act within its host, at an instant of simulated time, with the same effect as in lock-step; the
   * host itself continues.
   */
  DDS("Cyclone DDS in simulated time"),
  /** Cyclone DDS in real time: scenarios run one after the other, and no node waits for another. */
  DDS_IN_REAL_TIME("Cyclone DDS in real time"),
  /** Nodes that run elsewhere, in real time; no node is started here. */
  DDS_ATTACHED("Cyclone DDS, attached");

  private final String words;

  SimulationDriver(String words) {
    this.words = words;
  }

  /** Returns a description for users. */
  public String words() {
    return words;
  }
}

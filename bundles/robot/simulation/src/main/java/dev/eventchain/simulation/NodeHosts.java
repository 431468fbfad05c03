package dev.eventchain.simulation;

/** Processes that run the nodes of a chain. */
interface NodeHosts extends AutoCloseable {

  /** The nodes. */
  NodeSession session();

  /** Ends the processes, also while somebody waits for their answers. */
  @Override
  void close();
}

package dev.eventchain.simulation.host;

/** Processes that run the nodes of a chain. */
public interface NodeHosts extends AutoCloseable {

  /** The nodes. */
  NodeSession session();

  /** Ends the processes, also while somebody waits for their answers. */
  @Override
  void close();
}

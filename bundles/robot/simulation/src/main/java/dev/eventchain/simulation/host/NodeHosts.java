package dev.eventchain.simulation.host;

/** Processes that run the nodes of a chain. */
public interface NodeHosts extends AutoCloseable {

  /** Returns the session with the nodes. */
  NodeSession session();

  /** Ends the processes, even while a thread waits for their answers. */
  @Override
  void close();
}

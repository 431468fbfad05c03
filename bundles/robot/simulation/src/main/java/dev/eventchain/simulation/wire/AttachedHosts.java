package dev.eventchain.simulation.wire;

import dev.eventchain.dds.DdsLibrary;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.host.NodeHosts;
import dev.eventchain.simulation.host.NodeSession;
import dev.eventchain.simulation.node.DdsAttachment;
import java.time.Duration;

/** The world alone, in the DDS domain of nodes that run elsewhere. */
public final class AttachedHosts implements NodeHosts {

  /** Description of the confinement of nodes that run elsewhere. */
  public static final String CONFINEMENT = "none by Eventchain: the nodes were started elsewhere";

  private final DdsParticipant participant;
  private final AttachedSession session;

  /**
   * Joins the domain.
   *
   * @param topics the topics that the nodes must have
   * @param patience maximum time to wait for nodes
   * @param python the environment with Cyclone DDS
   * @throws DiagnosticException (INPUT) {@code dds.domain.unusable}: Cyclone DDS rejects the
   *     configuration
   */
  public AttachedHosts(
      DdsAttachment where, ChainTopics topics, Duration patience, PythonEnvironment python) {
    DdsLibrary library = DdsLibrary.load(python.cycloneDds());
    try {
      participant =
          DdsParticipant.on(library, where.domain(), where.configuration(), where.distribution());
    } catch (IllegalArgumentException | IllegalStateException e) {
      throw DdsAttachment.unusable(
          e.getMessage(),
          "Look at "
              + DdsAttachment.CONFIGURATION
              + ": it holds XML, or the address of an XML file.");
    }
    try {
      participant.announce("eventchain_world");
      session = new AttachedSession(participant, topics, where, patience);
    } catch (RuntimeException | Error e) {
      participant.close();
      throw e;
    }
  }

  @Override
  public NodeSession session() {
    return session;
  }

  @Override
  public void close() {
    participant.close();
  }
}

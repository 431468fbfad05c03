package dev.eventchain.simulation.wire;

import dev.eventchain.dds.DdsLibrary;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.host.NodeHosts;
import dev.eventchain.simulation.host.NodeSession;
import dev.eventchain.simulation.node.DdsAttachment;
import java.time.Duration;

/** The world alone, in a DDS domain in which others run the nodes. */
public final class AttachedHosts implements NodeHosts {

  /** What there is to say of the confinement of nodes that others run. */
  public static final String CONFINEMENT = "none by Eventchain: the nodes were started elsewhere";

  private final DdsParticipant participant;
  private final AttachedSession session;

  /**
   * Takes part.
   *
   * @param topics those that the nodes have to have
   * @param patience how long nodes are waited for
   * @param python knows where Cyclone DDS is
   * @throws DiagnosticException (INPUT) {@code dds.domain.unusable}: Cyclone DDS refuses the
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

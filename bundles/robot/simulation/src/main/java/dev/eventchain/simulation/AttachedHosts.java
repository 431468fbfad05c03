package dev.eventchain.simulation;

import dev.eventchain.dds.DdsLibrary;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.SimulationRequest.Attachment;
import java.util.Map;

/** The world alone, in a DDS domain in which others run the nodes. */
final class AttachedHosts implements NodeHosts {

  /** What there is to say of the confinement of nodes that others run. */
  static final String CONFINEMENT = "none by Eventchain: the nodes were started elsewhere";

  private static final String DOMAIN = "ROS_DOMAIN_ID";
  private static final String CONFIGURATION = "CYCLONEDDS_URI";
  private static final int HIGHEST_DOMAIN = 230;

  private final DdsParticipant participant;
  private final AttachedSession session;

  /**
   * Takes part.
   *
   * @param python knows where Cyclone DDS is
   * @throws DiagnosticException (INPUT) {@code dds.domain.unusable}: Cyclone DDS refuses the
   *     configuration
   */
  AttachedHosts(SimulationRequest request, NodeSetup setup, PythonEnvironment python) {
    Attachment where = request.attachment().orElseThrow();
    DdsLibrary library = DdsLibrary.load(python.cycloneDds());
    try {
      participant = DdsParticipant.on(library, where.domain(), where.configuration());
    } catch (IllegalArgumentException | IllegalStateException e) {
      throw unusable(
          e.getMessage(),
          "Look at " + CONFIGURATION + ": it holds XML, or the address of an XML file.");
    }
    try {
      participant.announce("eventchain_world");
      session = new AttachedSession(participant, setup, where, request.limits().wallTime());
    } catch (RuntimeException | Error e) {
      participant.close();
      throw e;
    }
  }

  /** See {@link Attachment#of}. */
  static Attachment attachment(Map<String, String> environment) {
    String text = environment.getOrDefault(DOMAIN, "").strip();
    int domain = text.isEmpty() ? 0 : text.matches("[0-9]{1,3}") ? Integer.parseInt(text) : -1;
    if (domain < 0 || domain > HIGHEST_DOMAIN) {
      throw unusable(
          DOMAIN + " is '" + text + "', which is not a domain.",
          "Domains are numbered from 0 to " + HIGHEST_DOMAIN + "; the default is 0.");
    }
    boolean local =
        environment.getOrDefault("ROS_LOCALHOST_ONLY", "").equals("1")
            || environment.getOrDefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "").equals("LOCALHOST");
    String own = environment.getOrDefault(CONFIGURATION, "");
    String loopback = local ? DdsParticipant.loopbackConfiguration() : "";
    // What comes later wins, as where the middleware of ROS 2 puts its own before the user's.
    String both = loopback + (loopback.isEmpty() || own.isEmpty() ? "" : ",") + own;
    return new Attachment(domain, both);
  }

  private static DiagnosticException unusable(String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error("dds.domain.unusable", message, SourceLocation.NONE).withHint(hint));
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

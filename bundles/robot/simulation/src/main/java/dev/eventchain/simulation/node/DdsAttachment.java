package dev.eventchain.simulation.node;

import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.Map;

/**
 * DDS domain of nodes that run elsewhere.
 *
 * @param domain the number of the DDS domain
 * @param configuration the Cyclone DDS configuration, XML or any value of {@code CYCLONEDDS_URI};
 *     empty for its defaults
 * @param distribution the ROS 2 release of the nodes, as in {@code ROS_DISTRO}; empty for the
 *     newest
 */
public record DdsAttachment(int domain, String configuration, String distribution) {

  /** Creates an attachment to nodes of the newest ROS 2 release. */
  public DdsAttachment(int domain, String configuration) {
    this(domain, configuration, "");
  }

  /** Environment variable with the configuration of Cyclone DDS. */
  public static final String CONFIGURATION = "CYCLONEDDS_URI";

  private static final String DOMAIN = "ROS_DOMAIN_ID";
  private static final String DISTRIBUTION = "ROS_DISTRO";

  /**
   * Reads the environment variables of ROS 2: {@code ROS_DOMAIN_ID}, {@code CYCLONEDDS_URI} and
   * {@code ROS_DISTRO}. Restricts DDS to the loopback interface if {@code ROS_LOCALHOST_ONLY} is 1
   * or {@code ROS_AUTOMATIC_DISCOVERY_RANGE} is LOCALHOST, and only then.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) {@code dds.domain.unusable}:
   *     there is no such domain
   */
  public static DdsAttachment of(Map<String, String> environment) {
    String text = environment.getOrDefault(DOMAIN, "").strip();
    int domain = text.isEmpty() ? 0 : text.matches("[0-9]{1,3}") ? Integer.parseInt(text) : -1;
    if (domain < 0 || domain > DdsParticipant.HIGHEST_DOMAIN) {
      throw unusable(
          DOMAIN + " is '" + text + "', which is not a domain.",
          "Domains are numbered from 0 to "
              + DdsParticipant.HIGHEST_DOMAIN
              + "; the default is 0.");
    }
    boolean local =
        environment.getOrDefault("ROS_LOCALHOST_ONLY", "").equals("1")
            || environment.getOrDefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "").equals("LOCALHOST");
    String own = environment.getOrDefault(CONFIGURATION, "");
    String loopback = local ? DdsParticipant.loopbackConfiguration() : "";
    // Later entries take precedence, so the user's configuration comes last, as in the ROS 2
    // middleware.
    String both = loopback + (loopback.isEmpty() || own.isEmpty() ? "" : ",") + own;
    return new DdsAttachment(domain, both, environment.getOrDefault(DISTRIBUTION, ""));
  }

  /** Creates the exception for an unusable domain or configuration. */
  public static DiagnosticException unusable(String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(NodeRules.DDS_DOMAIN_UNUSABLE, message, SourceLocation.NONE).withHint(hint));
  }
}

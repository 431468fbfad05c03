package dev.eventchain.simulation.node;

import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.Map;

/**
 * Where to find nodes that are run elsewhere.
 *
 * @param domain the number of the DDS domain
 * @param configuration of Cyclone DDS, XML or what {@code CYCLONEDDS_URI} may hold; empty for its
 *     defaults
 * @param distribution the release of ROS 2 of the nodes, as {@code ROS_DISTRO} has it; empty for
 *     the newest
 */
public record DdsAttachment(int domain, String configuration, String distribution) {

  /** With nodes of the newest release of ROS 2. */
  public DdsAttachment(int domain, String configuration) {
    this(domain, configuration, "");
  }

  /** The variable that holds the configuration of Cyclone DDS. */
  public static final String CONFIGURATION = "CYCLONEDDS_URI";

  private static final String DOMAIN = "ROS_DOMAIN_ID";
  private static final String DISTRIBUTION = "ROS_DISTRO";

  /**
   * As the environment says, as for nodes of ROS 2: {@code ROS_DOMAIN_ID}, {@code CYCLONEDDS_URI},
   * {@code ROS_DISTRO}, and the loopback interface only if {@code ROS_LOCALHOST_ONLY} is 1 or
   * {@code ROS_AUTOMATIC_DISCOVERY_RANGE} is LOCALHOST.
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
    // What comes later wins, as where the middleware of ROS 2 puts its own before the user's.
    String both = loopback + (loopback.isEmpty() || own.isEmpty() ? "" : ",") + own;
    return new DdsAttachment(domain, both, environment.getOrDefault(DISTRIBUTION, ""));
  }

  /** The refusal of a domain or of a configuration that cannot be used. */
  public static DiagnosticException unusable(String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error("dds.domain.unusable", message, SourceLocation.NONE).withHint(hint));
  }
}

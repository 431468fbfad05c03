package dev.eventchain.simulation.wire;

import dev.eventchain.dds.DdsParticipant.Peer;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.time.Duration;
import java.util.List;
import java.util.Locale;

/** Failures of a scenario with nodes that run elsewhere. */
final class AttachedFailures {

  private static final double SECOND = 1e9;

  private AttachedFailures() {}

  /** Creates the exception for nodes that are missing or do not match. */
  static DiagnosticException unmatched(
      Outside outside, List<String> missing, int domain, Duration patience) {
    String who =
        outside.isEmpty()
            ? "No node was found in domain " + domain
            : "The nodes in domain " + domain + " do not meet the world";
    String others =
        outside.nodes().isEmpty()
            ? ""
            : " Nodes found: " + String.join(", ", outside.nodes()) + ".";
    String hint =
        outside.isEmpty()
            ? "Start the nodes, with the same ROS_DOMAIN_ID; ROS_LOCALHOST_ONLY and CYCLONEDDS_URI"
                + " have to let both sides reach each other."
            : "Compare the names of topics, and the types and quality of service of both ends.";
    return finding(
        WireRules.SIMULATION_WIRE_UNMATCHED,
        "%s, within %s s: %s.%s"
            .formatted(who, seconds(patience.toNanos()), String.join("; ", missing), others),
        hint);
  }

  private static String seconds(long nanos) {
    return String.format(Locale.ROOT, "%.1f", nanos / SECOND).replaceFirst("\\.0$", "");
  }

  /** Creates the exception for nodes that have vanished. */
  static DiagnosticException vanished(List<Peer> gone, long now) {
    return finding(
        WireRules.SIMULATION_NODE_LOST,
        String.format(
            Locale.ROOT,
            "%.3f s into the scenario, this vanished from the wire: %s.",
            now / SECOND,
            Outside.vanished(gone)),
        "Did the node end, or its machine lose the network? What the vehicle did from then on says"
            + " nothing about the software.");
  }

  /** Creates the exception for readers that do not acknowledge the messages of the world. */
  static DiagnosticException deaf(String topic, long now) {
    return finding(
        WireRules.SIMULATION_NODE_LOST,
        String.format(
            Locale.ROOT,
            "%.3f s into the scenario, the messages on %s were no longer received.",
            now / SECOND,
            topic),
        "A reader that asks for reliable delivery no longer acknowledges them: is its process"
            + " stopped?");
  }

  private static DiagnosticException finding(Rule rule, String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.FINDINGS,
        Diagnostic.of(rule, message, SourceLocation.NONE).withHint(hint));
  }
}

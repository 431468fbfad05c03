package dev.eventchain.simulation.wire;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.host.UserFiles;
import java.util.List;
import java.util.Locale;

/** Findings on nodes that are stopped or cannot be reached. */
public final class NodeLoss {

  private static final double SECOND = 1e9;

  private NodeLoss() {}

  /** Creates the exception for a stopped node. */
  static DiagnosticException stopped(String node, long now, UserFiles files) {
    return finding(
        WireRules.SIMULATION_NODE_LOST,
        "Node " + node + " was stopped " + at(now) + " and did nothing from then on.",
        "Something has sent SIGSTOP to its process.",
        node,
        files);
  }

  /** Creates the exception for a node that does not answer although its process could. */
  static DiagnosticException silent(String node, long now, String wait, UserFiles files) {
    return finding(
        WireRules.SIMULATION_NODE_LOST,
        "Node " + node + " did not answer within " + wait + ", " + at(now) + ".",
        "Look for an endless loop or a wait in the node.",
        node,
        files);
  }

  /** Creates the exception for samples that do not arrive although all nodes answer. */
  static DiagnosticException unreachable(List<String> ends, long now, UserFiles files) {
    return finding(
        WireRules.SIMULATION_NODE_LOST,
        "Messages do not arrive, " + at(now) + ": " + String.join(", ", ends) + ".",
        "All nodes answer. Is the loopback interface overloaded, or filtered?",
        "",
        files);
  }

  /** Creates the exception for writers and readers that have not matched. */
  public static DiagnosticException unmatched(List<String> missing, UserFiles files) {
    return finding(
        WireRules.SIMULATION_WIRE_UNMATCHED,
        "Not connected in time: " + String.join("; ", missing) + ".",
        "Nodes communicate over the loopback interface: is it up, and does it let UDP through?",
        "",
        files);
  }

  private static String at(long now) {
    return String.format(Locale.ROOT, "%.3f s into the scenario", now / SECOND);
  }

  private static DiagnosticException finding(
      Rule rule, String message, String hint, String node, UserFiles files) {
    SourceLocation folder = files.folder();
    SourceLocation location =
        new SourceLocation(folder.file(), folder.line(), folder.column(), node, "");
    return new DiagnosticException(
        DiagnosticException.Reason.FINDINGS, Diagnostic.of(rule, message, location).withHint(hint));
  }
}

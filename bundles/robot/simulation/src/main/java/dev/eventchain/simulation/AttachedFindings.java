package dev.eventchain.simulation;

import dev.eventchain.dds.DdsParticipant.Peer;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.ScenarioRunner.Run;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/** Findings about nodes that others run. */
final class AttachedFindings {

  private static final double SECOND = 1e9;

  private AttachedFindings() {}

  /** Nodes are not there, or do not fit. */
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
        "simulation.wire.unmatched",
        "%s, within %s s: %s.%s"
            .formatted(who, seconds(patience.toNanos()), String.join("; ", missing), others),
        hint);
  }

  private static String seconds(long nanos) {
    return String.format(Locale.ROOT, "%.1f", nanos / SECOND).replaceFirst("\\.0$", "");
  }

  /** Nodes are not there any more. */
  static DiagnosticException vanished(List<Peer> gone, long now) {
    return finding(
        "simulation.node.lost",
        String.format(
            Locale.ROOT,
            "%.3f s into the scenario, this vanished from the wire: %s.",
            now / SECOND,
            Outside.vanished(gone)),
        "Did the node end, or its machine lose the network? What the vehicle did from then on says"
            + " nothing about the software.");
  }

  /** Nobody acknowledges what the world publishes. */
  static DiagnosticException deaf(String topic, long now) {
    return finding(
        "simulation.node.lost",
        String.format(
            Locale.ROOT,
            "%.3f s into the scenario, the messages on %s were no longer received.",
            now / SECOND,
            topic),
        "A reader that asks for reliable delivery no longer acknowledges them: is its process"
            + " stopped?");
  }

  private static DiagnosticException finding(String id, String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.FINDINGS,
        Diagnostic.error(id, message, SourceLocation.NONE).withHint(hint));
  }

  /** The topics that nodes write and the vehicle takes, in the bench's order. */
  static List<String> taken(NodeSetup setup) {
    Set<String> written = setup.topicsWritten();
    return setup.bench().consumed().keySet().stream().filter(written::contains).toList();
  }

  /** Nothing came to the vehicle in a scenario, which says nothing about the software then. */
  static List<Diagnostic> silentIn(Run run, NodeSetup setup) {
    List<String> taken = taken(setup);
    if (taken.stream().anyMatch(topic -> !run.log().publicationsOf(topic).isEmpty())) {
      return List.of();
    }
    String topics = taken.isEmpty() ? "any topic" : String.join(", ", taken);
    return List.of(
        silent(
            "Scenario %s: the vehicle received nothing on %s."
                .formatted(run.scenario().name(), topics),
            taken.isEmpty() ? "" : setup.writer(taken.get(0))));
  }

  /** What the vehicle takes and nothing wrote in any scenario, although other messages came. */
  static List<Diagnostic> neverHeard(List<Run> runs, NodeSetup setup) {
    List<String> taken = taken(setup);
    boolean anything = runs.stream().anyMatch(run -> silentIn(run, setup).isEmpty());
    return taken.stream()
        .filter(topic -> anything)
        .filter(topic -> runs.stream().allMatch(run -> run.log().publicationsOf(topic).isEmpty()))
        .map(topic -> silent(topic + " never arrived in any scenario.", setup.writer(topic)))
        .toList();
  }

  private static Diagnostic silent(String message, String element) {
    return Diagnostic.error(
            "simulation.node.silent", message, SourceLocation.NONE.withElement(element))
        .withHint("Do the nodes get their inputs, and do they follow /clock?");
  }

  /** What has to be known of a result that was had with nodes of others. */
  static List<Diagnostic> about(List<Run> runs, NodeSetup setup) {
    List<Diagnostic> found = new ArrayList<>();
    found.add(unseen(runs, setup));
    if (runs.size() > 1) {
      found.add(
          Diagnostic.warning(
                  "simulation.attached.state",
                  ("%d scenarios were driven with the same nodes, which were not restarted:"
                          + " from the second one on they remember what happened before.")
                      .formatted(runs.size()),
                  SourceLocation.NONE)
              .withHint("Restart the nodes for each scenario, and run it alone: --scenario NAME."));
    }
    return found;
  }

  private static Diagnostic unseen(List<Run> runs, NodeSetup setup) {
    Set<String> silent = new TreeSet<>(setup.topicsWritten());
    runs.forEach(run -> silent.removeAll(run.log().publications().keySet()));
    String unheard =
        silent.isEmpty() ? "" : " Nothing was received on " + String.join(", ", silent) + ".";
    return Diagnostic.info(
            "simulation.attached.unseen",
            ("The nodes were started elsewhere (%s): their executions, periods, execution times,"
                    + " latencies and ages of inputs were not measured.%s")
                .formatted(setup.driverWords(), unheard),
            SourceLocation.NONE)
        .withHint("Simulate with a driver that starts the nodes to measure them.");
  }
}

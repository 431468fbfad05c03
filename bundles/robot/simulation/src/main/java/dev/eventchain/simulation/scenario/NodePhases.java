package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The phases of nodes that a scenario sets: when their timers first fire.
 *
 * @param milliseconds by the names of the nodes
 * @param places where each is set
 */
record NodePhases(Map<String, Double> milliseconds, Map<String, SourceLocation> places) {

  static final NodePhases NONE = new NodePhases(Map.of(), Map.of());

  static NodePhases read(ObjectReader section) {
    Map<String, Double> milliseconds = new LinkedHashMap<>();
    Map<String, SourceLocation> places = new LinkedHashMap<>();
    for (String node : section.names()) {
      milliseconds.put(node, section.requiredNumber(node, NumberRange.of(0, 60_000)));
      places.put(node, section.atKey(node));
    }
    return new NodePhases(milliseconds, places);
  }

  /** Returns a finding for each node that a chain does not have: another design has other nodes. */
  List<Diagnostic> unknown(Collection<String> nodes) {
    return places.keySet().stream()
        .filter(node -> !nodes.contains(node))
        .map(
            node ->
                Diagnostic.of(
                        ScenarioRules.NODE_UNKNOWN,
                        "The chain has no node '" + node + "', whose phase is set here.",
                        places.get(node))
                    .withHint(NearestName.hint(node, nodes)))
        .toList();
  }
}

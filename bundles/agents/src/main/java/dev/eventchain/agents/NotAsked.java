package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.description.ChainNames;
import dev.eventchain.description.EventChainSchema;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.jsonmodels.JsonDocument;
import java.util.Set;

/**
 * Properties of components in chain descriptions that prompts leave out: budgets, which inputs are
 * synchronized, what executes a component, and how long its messages are on their way. They do not
 * affect what a component computes from its inputs, so changing them needs no new answer.
 */
final class NotAsked {
  private static final Set<String> KEYS =
      Set.of(
          ChainNames.BEST_CASE_EXECUTION_TIME,
          ChainNames.WORST_CASE_EXECUTION_TIME,
          ChainNames.MEMORY,
          ChainNames.SYNCHRONIZED,
          ChainNames.TOLERANCE,
          ChainNames.PROCESSOR,
          ChainNames.PRIORITY);

  private NotAsked() {}

  /** Returns the components without these properties, as an array. */
  static String without(SourceText components) {
    JsonNode json = EventChainSchema.components(JsonDocument.parse(components).root()).deepCopy();
    json.forEach(NotAsked::remove);
    return JsonLayout.compact(json) + "\n";
  }

  /** Returns the component without these properties. */
  static JsonNode without(JsonNode component) {
    JsonNode copy = component.deepCopy();
    remove(copy);
    return copy;
  }

  private static void remove(JsonNode component) {
    if (component instanceof ObjectNode object) {
      object.remove(KEYS);
      object.path(ChainNames.INPUT).forEach(NotAsked::removeTransport);
      object.path(ChainNames.OUTPUT).forEach(NotAsked::removeTransport);
    }
  }

  private static void removeTransport(JsonNode port) {
    if (port instanceof ObjectNode object) {
      object.remove(ChainNames.WORST_CASE_TRANSPORT_TIME);
    }
  }
}

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
 * Budgets of components in chain descriptions. They do not affect behaviour, so prompts leave them
 * out: a new budget needs no new answer.
 */
final class Budgets {
  private static final Set<String> KEYS =
      Set.of(
          ChainNames.BEST_CASE_EXECUTION_TIME,
          ChainNames.WORST_CASE_EXECUTION_TIME,
          ChainNames.MEMORY);

  private Budgets() {}

  /** Returns the components without budgets, as an array. */
  static String without(SourceText components) {
    JsonNode json = EventChainSchema.components(JsonDocument.parse(components).root()).deepCopy();
    json.forEach(Budgets::remove);
    return JsonLayout.compact(json) + "\n";
  }

  /** Returns the component without budgets. */
  static JsonNode without(JsonNode component) {
    JsonNode copy = component.deepCopy();
    remove(copy);
    return copy;
  }

  private static void remove(JsonNode component) {
    if (component instanceof ObjectNode object) {
      object.remove(KEYS);
    }
  }
}

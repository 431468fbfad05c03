package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.agents.chain.ChainView;
import dev.eventchain.description.ChainNames;
import dev.eventchain.description.EventChainSchema;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.jsonmodels.JsonDocument;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Properties of components in chain descriptions that prompts leave out: budgets, which inputs are
 * synchronized, what executes a component, and how long its messages are on their way. They do not
 * affect what a component computes from its inputs, so changing them needs no new answer. Of the
 * two units of a converted value, a prompt shows the one that its task is about.
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

  /**
   * Returns the components without these properties, as an array. Units are those of messages,
   * since the task is about what components exchange.
   */
  static String without(SourceText components) {
    JsonNode json = EventChainSchema.components(JsonDocument.parse(components).root()).deepCopy();
    for (JsonNode component : json) {
      remove(component);
      values(component).forEach(value -> value.remove(ChainNames.COMPONENT_UNIT));
    }
    return JsonLayout.compact(json) + "\n";
  }

  /**
   * Returns the component without these properties. Its values are as it knows them, since the task
   * is about what it computes.
   */
  static JsonNode without(JsonNode component) {
    JsonNode copy = component.deepCopy();
    remove(copy);
    values(copy).forEach(ChainView::asInComponent);
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

  private static List<ObjectNode> values(JsonNode component) {
    List<ObjectNode> values = new ArrayList<>();
    for (String side : List.of(ChainNames.INPUT, ChainNames.OUTPUT)) {
      for (JsonNode port : component.path(side)) {
        for (JsonNode value : port.path(ChainNames.VALUES)) {
          if (value instanceof ObjectNode object) {
            values.add(object);
          }
        }
      }
    }
    return values;
  }
}

package dev.eventchain.agents.chain;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.description.ChainNames;
import dev.eventchain.description.EventChainSchema;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.sandbox.ComponentSignature;
import java.util.ArrayList;
import java.util.List;

/**
 * An event-chain description for the checks. Missing parts are empty: the reader of descriptions
 * reports them.
 *
 * @param components the components in chain order
 */
public record ChainView(List<ChainView.Component> components) {
  /**
   * A component.
   *
   * @param pointer its JSON pointer
   */
  public record Component(
      String name, JsonNode json, String pointer, List<Port> inputs, List<Port> outputs) {
    public List<Value> inputValues() {
      return inputs.stream().flatMap(port -> port.values().stream()).toList();
    }

    public List<Value> outputValues() {
      return outputs.stream().flatMap(port -> port.values().stream()).toList();
    }

    /** Returns the signature required of its class. */
    public ComponentSignature signature() {
      return new ComponentSignature(
          name,
          names(inputValues()),
          names(outputValues()),
          outputValues().stream().map(Value::type).toList());
    }

    private static List<String> names(List<Value> values) {
      return values.stream().map(Value::name).toList();
    }
  }

  /**
   * A topic that a component reads or writes.
   *
   * @param pointer its JSON pointer
   */
  record Port(String topic, String pointer, List<Value> values) {}

  /**
   * A value that a component reads or writes.
   *
   * @param unit empty if none is stated
   * @param pointer its JSON pointer
   */
  public record Value(String name, String type, String unit, String pointer) {}

  public static ChainView of(JsonNode description) {
    JsonNode chain = EventChainSchema.components(description);
    List<Component> components = new ArrayList<>();
    for (int i = 0; i < chain.size(); i++) {
      components.add(component(chain.get(i), "/" + i));
    }
    return new ChainView(components);
  }

  /**
   * Returns a component of a valid chain.
   *
   * @throws IllegalArgumentException if the chain has no such component
   */
  public static Component component(SourceText chain, String name) {
    return of(JsonDocument.parse(chain).root()).components().stream()
        .filter(candidate -> candidate.name().equals(name))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("the chain has no component " + name));
  }

  static Component component(JsonNode json, String pointer) {
    return new Component(
        text(json, ChainNames.NAME),
        json,
        pointer,
        ports(json.path(ChainNames.INPUT), pointer + "/" + ChainNames.INPUT),
        ports(json.path(ChainNames.OUTPUT), pointer + "/" + ChainNames.OUTPUT));
  }

  private static List<Port> ports(JsonNode json, String pointer) {
    List<Port> ports = new ArrayList<>();
    for (int i = 0; i < json.size(); i++) {
      JsonNode port = json.path(i);
      String here = pointer + "/" + i;
      ports.add(
          new Port(
              text(port, ChainNames.TOPIC),
              here,
              values(port.path(ChainNames.VALUES), here + "/" + ChainNames.VALUES)));
    }
    return ports;
  }

  private static List<Value> values(JsonNode json, String pointer) {
    List<Value> values = new ArrayList<>();
    for (int i = 0; i < json.size(); i++) {
      JsonNode value = json.path(i);
      values.add(
          new Value(
              text(value, ChainNames.NAME),
              text(value, ChainNames.TYPE),
              text(value, ChainNames.UNIT),
              pointer + "/" + i));
    }
    return values;
  }

  private static String text(JsonNode json, String property) {
    return json.path(property).asText("");
  }
}

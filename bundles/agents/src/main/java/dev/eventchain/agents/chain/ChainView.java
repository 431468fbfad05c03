package dev.eventchain.agents.chain;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.description.ChainNames;
import dev.eventchain.description.EventChainSchema;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.messages.UnitConversion;
import dev.eventchain.sandbox.ComponentSignature;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

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

    /** Returns the types of its inputs as message definitions write them. */
    public List<String> inputTypes() {
      return inputValues().stream().map(Value::type).toList();
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
  public record Port(String topic, String pointer, List<Value> values) {}

  /**
   * A value that a component reads or writes.
   *
   * @param type as the component knows it
   * @param unit within the component; empty if none is stated
   * @param field the path of its field in messages
   * @param converted where it comes from or goes to in other units
   * @param isSafe that it states what is published of it while inputs are too old
   * @param pointer its JSON pointer
   */
  public record Value(
      String name,
      String type,
      String unit,
      String field,
      Optional<Converted> converted,
      boolean isSafe,
      String pointer) {

    /** Returns the type of its field in messages. */
    public String fieldType() {
      return converted.map(Converted::type).orElse(type);
    }
  }

  /**
   * The field of a message behind a value whose unit is converted.
   *
   * @param type the type of the field
   * @param conversion from the unit of the message to that of the component
   */
  public record Converted(String type, UnitConversion conversion) {}

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

  /**
   * Changes the description of a value whose unit is converted to what the component knows of it: a
   * number with floating point, in its own unit.
   */
  public static void asInComponent(ObjectNode value) {
    String own = text(value, ChainNames.COMPONENT_UNIT).strip();
    value.remove(ChainNames.COMPONENT_UNIT);
    if (!own.isEmpty() && !own.equals(text(value, ChainNames.UNIT).strip())) {
      value.put(ChainNames.UNIT, own);
      if (!text(value, ChainNames.TYPE).matches("float.*|double")) {
        value.put(ChainNames.TYPE, "float64");
      }
    }
  }

  private static Value value(JsonNode json, String pointer) {
    ObjectNode own = JsonNodeFactory.instance.objectNode();
    if (json instanceof ObjectNode object) {
      own.setAll(object);
      asInComponent(own);
    }
    String unit = text(own, ChainNames.UNIT);
    Optional<Converted> converted =
        json.has(ChainNames.COMPONENT_UNIT)
            ? UnitConversion.between(text(json, ChainNames.UNIT), unit)
                .map(conversion -> new Converted(text(json, ChainNames.TYPE), conversion))
            : Optional.empty();
    return new Value(
        text(own, ChainNames.NAME),
        text(own, ChainNames.TYPE),
        unit,
        text(own, ChainNames.FIELD),
        converted,
        json.hasNonNull(ChainNames.SAFE_VALUE),
        pointer);
  }

  private static List<Value> values(JsonNode json, String pointer) {
    List<Value> values = new ArrayList<>();
    for (int i = 0; i < json.size(); i++) {
      values.add(value(json.path(i), pointer + "/" + i));
    }
    return values;
  }

  private static String text(JsonNode json, String property) {
    return json.path(property).asText("");
  }
}

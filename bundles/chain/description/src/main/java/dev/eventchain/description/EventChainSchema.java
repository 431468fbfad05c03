package dev.eventchain.description;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.jsonmodels.EnumLimits;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.model.eventchain.Durability;
import dev.eventchain.model.eventchain.History;
import dev.eventchain.model.eventchain.Liveliness;
import dev.eventchain.model.eventchain.Reliability;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.eclipse.emf.common.util.Enumerator;

/**
 * JSON Schema of the event-chain descriptions for {@link EventChainReader}, as far as the designer
 * of a chain writes them. Strict modes require an object at the root, so the array of components is
 * in its property {@code components}.
 *
 * <p>Only closed sets are enumerations: the ids of the requirements, the known message types, the
 * profiles and policies of quality of service, and {@code external}. Free are names and topics,
 * because a chain may define new ones; units and types of fields, because they are composed (m/s2,
 * float32[4]); and fields, because they depend on the message type.
 *
 * <p>The properties are in the order of the paper's template, so that a threshold in the
 * description precedes the ports.
 */
public final class EventChainSchema {

  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;
  private static final String REQUIREMENT = "requirement";
  private static final String POLICIES = "policies";

  private final Collection<String> requirements;
  private final Collection<String> messageTypes;

  private EventChainSchema(Collection<String> requirements, Collection<String> messageTypes) {
    this.requirements = requirements;
    this.messageTypes = messageTypes;
  }

  /**
   * Returns the schema of a chain.
   *
   * @param requirements the ids of all requirements
   * @param messageTypes the full names of all message types
   */
  public static EventChainSchema of(
      Collection<String> requirements, Collection<String> messageTypes) {
    return new EventChainSchema(
        requirements.stream().distinct().toList(), List.copyOf(new TreeSet<>(messageTypes)));
  }

  /** Returns the schema in which every property is required but may be null. */
  public ObjectNode nested() {
    return new Shape(true).root();
  }

  /** Returns the schema in which properties without a value are omitted. */
  public ObjectNode flat() {
    return new Shape(false).root();
  }

  /** Returns the schema of the array itself, as in the paper; otherwise as {@link #nested()}. */
  public ObjectNode array() {
    return new Shape(true).defined(array(pointer("component")));
  }

  /**
   * Returns the components of a description: the root array, or the array in an object of the
   * schema. Anything else is returned unchanged.
   */
  public static JsonNode components(JsonNode description) {
    return isWrapped(description) ? description.get(ChainNames.COMPONENTS) : description;
  }

  /** Returns readers of the components; anything else is a finding. */
  static List<ObjectReader> objects(Document description, Consumer<Diagnostic> findings) {
    if (!isWrapped(description.root())) {
      return description.objects(findings);
    }
    ObjectReader root = description.object("", findings).orElseThrow();
    List<ObjectReader> components = root.objects(ChainNames.COMPONENTS);
    root.refuseOthers();
    return components;
  }

  private static boolean isWrapped(JsonNode description) {
    return description.isObject() && description.path(ChainNames.COMPONENTS).isArray();
  }

  /** Builder of a schema. */
  private final class Shape {

    private final boolean nested;

    Shape(boolean nested) {
      this.nested = nested;
    }

    ObjectNode root() {
      return defined(
          new Properties().always(ChainNames.COMPONENTS, array(pointer("component"))).closed());
    }

    ObjectNode defined(ObjectNode root) {
      ObjectNode definitions = root.putObject("$defs");
      definitions.set("component", component());
      definitions.set("input", port(value(ChainNames.MAXIMUM_AGE, type("number"))).closed());
      definitions.set("output", output());
      definitions.set(ChainNames.MESSAGE_TYPE, oneOf(messageTypes));
      definitions.set(REQUIREMENT, oneOf(requirements));
      definitions.set(POLICIES, policies());
      return EnumLimits.keep(root);
    }

    private ObjectNode component() {
      return new Properties()
          .always(ChainNames.NAME, type("string"))
          .always(ChainNames.DESCRIPTION, type("string"))
          .always(ChainNames.FREQUENCY, type("number").put("description", "Hz"))
          .maybe(ChainNames.WORST_CASE_EXECUTION_TIME, type("number").put("description", "ms"))
          .always(ChainNames.REQUIREMENTS, array(pointer(REQUIREMENT)))
          .always(ChainNames.INPUT, array(pointer("input")))
          .always(ChainNames.OUTPUT, array(pointer("output")))
          .closed();
    }

    private ObjectNode output() {
      ObjectNode safe = JSON.objectNode();
      safe.putArray("anyOf").add(type("number")).add(type("boolean")).add(type("string"));
      return port(value(ChainNames.SAFE_VALUE, safe))
          .maybe(ChainNames.CONSUMER, oneOf(List.of(ChainNames.EXTERNAL)))
          .always(ChainNames.REQUIREMENTS, array(pointer(REQUIREMENT)))
          .closed();
    }

    private Properties port(ObjectNode value) {
      return new Properties()
          .always(ChainNames.TOPIC, type("string"))
          .always(ChainNames.MESSAGE_TYPE, pointer(ChainNames.MESSAGE_TYPE))
          .maybe(ChainNames.QOS_PROFILE, qos())
          .always(ChainNames.VALUES, array(value));
    }

    private ObjectNode value(String last, ObjectNode type) {
      return new Properties()
          .always(ChainNames.NAME, type("string"))
          .always(ChainNames.FIELD, type("string"))
          .always(ChainNames.TYPE, type("string"))
          .maybe(ChainNames.UNIT, type("string"))
          .always(ChainNames.DESCRIPTION, type("string"))
          .maybe(last, type)
          .closed();
    }

    private ObjectNode qos() {
      List<String> names = new ArrayList<>(QosSettings.names());
      names.addAll(QosReader.RELIABILITIES);
      ObjectNode qos = JSON.objectNode();
      qos.putArray("anyOf")
          .add(oneOf(names))
          .add(type("integer").put("description", "The depth of the profile default."))
          .add(pointer(POLICIES));
      return qos;
    }

    private ObjectNode policies() {
      return new Properties()
          .always(ChainNames.PROFILE, oneOf(QosSettings.names()))
          .maybe(ChainNames.RELIABILITY, oneOf(names(Reliability.VALUES)))
          .maybe(ChainNames.DURABILITY, oneOf(names(Durability.VALUES)))
          .maybe(ChainNames.HISTORY, oneOf(names(History.VALUES)))
          .maybe(ChainNames.DEPTH, type("integer"))
          .maybe(ChainNames.DEADLINE, type("number").put("description", "ms"))
          .maybe(ChainNames.LIVELINESS, oneOf(names(Liveliness.VALUES)))
          .maybe(ChainNames.LEASE_DURATION, type("number").put("description", "ms"))
          .closed();
    }

    /** The properties of an object. */
    private final class Properties {

      private final ObjectNode all = JSON.objectNode();
      private final ArrayNode required = JSON.arrayNode();

      Properties always(String name, ObjectNode schema) {
        all.set(name, schema);
        required.add(name);
        return this;
      }

      Properties maybe(String name, ObjectNode schema) {
        if (nested) {
          return always(name, orNull(schema));
        }
        all.set(name, schema);
        return this;
      }

      ObjectNode closed() {
        ObjectNode schema = type("object");
        schema.set("properties", all);
        schema.set("required", required);
        return schema.put("additionalProperties", false);
      }
    }
  }

  private static ObjectNode orNull(ObjectNode schema) {
    if (schema.path("anyOf") instanceof ArrayNode alternatives) {
      alternatives.add(type("null"));
      return schema;
    }
    ObjectNode nullable = JSON.objectNode();
    nullable.putArray("anyOf").add(schema).add(type("null"));
    return nullable;
  }

  private static List<String> names(List<? extends Enumerator> literals) {
    return literals.stream().map(Enumerator::getName).toList();
  }

  private static ObjectNode pointer(String definition) {
    return JSON.objectNode().put("$ref", "#/$defs/" + definition);
  }

  private static ObjectNode array(ObjectNode items) {
    return type("array").set("items", items);
  }

  /** Returns an enumeration of values, or any text if there are none. */
  private static ObjectNode oneOf(Collection<String> values) {
    ObjectNode schema = type("string");
    if (!values.isEmpty()) {
      ArrayNode literals = schema.putArray("enum");
      values.forEach(literals::add);
    }
    return schema;
  }

  private static ObjectNode type(String name) {
    return JSON.objectNode().put("type", name);
  }
}

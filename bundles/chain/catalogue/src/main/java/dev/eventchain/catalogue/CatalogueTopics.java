package dev.eventchain.catalogue;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSignal.Role;
import dev.eventchain.model.Signal;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The topics of signals: {@code Vehicle.Speed} is {@code /vss/Vehicle/Speed}, and what an actuator
 * is to do is in {@code /vss_target/...}; {@code Engine.Speed} of a network is {@code
 * /can/Engine/Speed}. Each carries one value, in a message of std_msgs.
 */
final class CatalogueTopics {

  private static final String FIELD = "data";
  private static final String EACH = "A topic for each choice from the braces. ";

  /** Longest meaning in characters. */
  private static final int LONGEST = 400;

  /** Messages by the type of their field. */
  private static final Map<String, String> MESSAGES =
      Map.ofEntries(
          Map.entry("bool", "Bool"),
          Map.entry("string", "String"),
          Map.entry("float32", "Float32"),
          Map.entry("float64", "Float64"),
          Map.entry("int8", "Int8"),
          Map.entry("int16", "Int16"),
          Map.entry("int32", "Int32"),
          Map.entry("int64", "Int64"),
          Map.entry("uint8", "UInt8"),
          Map.entry("uint16", "UInt16"),
          Map.entry("uint32", "UInt32"),
          Map.entry("uint64", "UInt64"));

  private final String prefix;

  CatalogueTopics(String prefix) {
    this.prefix = prefix;
  }

  /** Returns the topics of a signal; none if no message of std_msgs holds its values. */
  List<Signal> of(CatalogueSignal signal) {
    Optional<String> message = signal.type().flatMap(CatalogueTopics::message);
    List<Signal> topics = new ArrayList<>();
    if (message.isPresent() && signal.role() == Role.COMMAND) {
      topics.add(topic(signal, prefix, message.get(), Signal.Direction.CONSUMED));
    } else if (message.isPresent()) {
      topics.add(topic(signal, prefix, message.get(), Signal.Direction.PROVIDED));
      if (signal.role() == Role.ACTUATOR) {
        topics.add(topic(signal, prefix + "_target", message.get(), Signal.Direction.CONSUMED));
      }
    }
    return topics;
  }

  private static Optional<String> message(String type) {
    String element = type.replace("[]", "");
    String multiple = type.equals(element) ? "" : "MultiArray";
    return Optional.ofNullable(MESSAGES.get(element))
        .map(name -> "std_msgs/msg/" + name + multiple);
  }

  private static Signal topic(
      CatalogueSignal signal, String first, String message, Signal.Direction direction) {
    String type = signal.type().orElseThrow();
    List<String> texts = type.equals("string") ? signal.allowed() : List.of();
    Signal.Values values = new Signal.Values(signal.least(), signal.most(), texts, signal.names());
    Signal.Field field = new Signal.Field(FIELD, type, signal.unit(), values, signal.location());
    return new Signal(
        "/" + first + "/" + signal.path().replace('.', '/'),
        message,
        direction,
        Optional.empty(),
        List.of(field),
        signal.location());
  }

  /** Returns topics in the form of {@code signals.json}; those of a group of signals at once. */
  String asJson(List<CatalogueSignal> signals) {
    ArrayNode all = JsonNodeFactory.instance.arrayNode();
    for (SignalGroup group : SignalGroup.of(signals)) {
      of(group.any()).forEach(topic -> all.add(json(topic, group)));
    }
    return all.toString();
  }

  private static ObjectNode json(Signal topic, SignalGroup group) {
    CatalogueSignal any = group.any();
    boolean wanted = topic.direction() == Signal.Direction.CONSUMED;
    String start = topic.topic().substring(0, topic.topic().length() - any.path().length());
    String meaning =
        wanted && any.role() == Role.ACTUATOR
            ? "Wanted value of the same signal; write it to change it."
            : shortened(any.meaning());
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("Topic Name", start + group.path().replace('.', '/'));
    json.put("Message Type", topic.messageType());
    json.put("direction", wanted ? "consumed" : "provided");
    ObjectNode field = json.putArray("Message Definition").addObject();
    field.put("Field", FIELD);
    field.put("Type", topic.fields().get(0).type());
    field.put("Description", group.signals().size() == 1 ? meaning : EACH + meaning);
    if (!any.unit().isEmpty()) {
      field.put("Unit", any.unit());
    }
    return json;
  }

  /** Returns a text without its end if it is long: some list dozens of values. */
  private static String shortened(String text) {
    return text.length() <= LONGEST ? text : text.substring(0, LONGEST) + " ...";
  }
}

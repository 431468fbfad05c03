package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * A topic that the vehicle or its software has, as signals.json describes it.
 *
 * @param topic the topic's name
 * @param messageType the type of its messages, with the package
 * @param direction who is on the other side
 * @param fields the fields that are described, by their path
 */
record Signal(String topic, String messageType, Direction direction, Map<String, Field> fields) {
  /** Where a signal comes from and goes to. */
  enum Direction {
    /** The vehicle sends it. */
    PROVIDED,
    /** The vehicle receives it. */
    CONSUMED,
    /** Only software has to do with it. */
    INTERNAL
  }

  /**
   * A field of the message.
   *
   * @param type its type as message definitions write it, or empty
   * @param unit its unit, or empty
   */
  record Field(String type, String unit) {}

  /** Reads an array of signals, by topic, in its order. */
  static Map<String, Signal> read(JsonNode signals) {
    Map<String, Signal> result = new LinkedHashMap<>();
    for (JsonNode json : signals) {
      Map<String, Field> fields = new LinkedHashMap<>();
      for (JsonNode field : json.path("Message Definition")) {
        fields.put(
            field.path("Field").asText(),
            new Field(field.path("Type").asText(""), field.path("Unit").asText("")));
      }
      String topic = json.path("Topic Name").asText();
      String type = MessageTypes.qualified(json.path("Message Type").asText()).orElse("");
      result.put(topic, new Signal(topic, type, direction(json), fields));
    }
    return result;
  }

  private static Direction direction(JsonNode json) {
    return switch (json.path("direction").asText()) {
      case "provided" -> Direction.PROVIDED;
      case "consumed" -> Direction.CONSUMED;
      default -> Direction.INTERNAL;
    };
  }

  Optional<Field> field(String path) {
    return Optional.ofNullable(fields.get(path));
  }
}

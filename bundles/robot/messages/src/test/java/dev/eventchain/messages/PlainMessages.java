package dev.eventchain.messages;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;

/** Messages as src/test/python/random_messages.py writes them. */
final class PlainMessages {

  private PlainMessages() {}

  static MessageValue read(MessageType type, JsonNode object) {
    MessageValue message = MessageValue.of(type);
    for (MessageType.Field field : type.fields()) {
      message.set(field.name(), read(field.type(), object.get(field.name())));
    }
    return message;
  }

  private static Object read(FieldType type, JsonNode node) {
    if (!node.isArray()) {
      return switch (type.kind()) {
        case MESSAGE -> read(type.message().orElseThrow(), node);
        case STRING -> node.asText();
        case BOOL -> node.asBoolean();
        case FLOAT32, FLOAT64 -> number(node.asText());
        default -> node.bigIntegerValue();
      };
    }
    List<Object> items = new ArrayList<>();
    node.forEach(item -> items.add(read(type, item)));
    return items;
  }

  private static double number(String text) {
    return switch (text) {
      case "nan" -> Double.NaN;
      case "inf" -> Double.POSITIVE_INFINITY;
      case "-inf" -> Double.NEGATIVE_INFINITY;
      default -> Double.parseDouble(text);
    };
  }
}

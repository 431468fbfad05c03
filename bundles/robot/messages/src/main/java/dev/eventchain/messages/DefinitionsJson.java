package dev.eventchain.messages;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.StringJoiner;

/**
 * Definitions of message types as JSON, the form that the Python runtime reads: an object with a
 * member for each type, sorted by name, such as
 *
 * <pre>{@code
 * "geometry_msgs/msg/Quaternion": {"fields": [["x", "float64"], ["w", "float64", 1.0]], "constants": []}
 * }</pre>
 *
 * A field consists of its name, its type in the syntax of the message language, with full names of
 * messages, and an optional default. A constant always has a value. Non-finite numbers are the
 * strings {@code nan}, {@code inf} and {@code -inf}.
 */
final class DefinitionsJson {

  private DefinitionsJson() {}

  static String of(Collection<MessageType> types) {
    StringJoiner json = new StringJoiner(",\n", "{\n", "\n}\n").setEmptyValue("{}\n");
    types.stream()
        .sorted(Comparator.comparing(MessageType::name))
        .forEach(type -> json.add(definition(type)));
    return json.toString();
  }

  private static String definition(MessageType type) {
    List<String> fields = new ArrayList<>();
    for (MessageType.Field field : type.fields()) {
      fields.add(member(field.name(), field.type(), field.defaultValue()));
    }
    List<String> constants = new ArrayList<>();
    for (MessageType.Constant constant : type.constants()) {
      constants.add(member(constant.name(), constant.type(), Optional.of(constant.value())));
    }
    return "%s: {\"fields\": [%s], \"constants\": [%s]}"
        .formatted(text(type.name()), String.join(", ", fields), String.join(", ", constants));
  }

  private static String member(String name, FieldType type, Optional<Object> value) {
    String start = "[" + text(name) + ", " + text(type.toString());
    return start + value.map(given -> ", " + value(type.kind(), given)).orElse("") + "]";
  }

  private static String value(FieldType.Kind kind, Object value) {
    if (value instanceof Collection<?> items) {
      StringJoiner list = new StringJoiner(", ", "[", "]");
      items.forEach(item -> list.add(value(kind, item)));
      return list.toString();
    }
    if (value.getClass().isArray()) {
      StringJoiner list = new StringJoiner(", ", "[", "]");
      for (int i = 0; i < Array.getLength(value); i++) {
        list.add(value(kind, Array.get(value, i)));
      }
      return list.toString();
    }
    if (value instanceof String given) {
      return text(given);
    }
    return value instanceof Number number ? number(kind, number) : value.toString();
  }

  private static String number(FieldType.Kind kind, Number number) {
    return switch (kind) {
      case FLOAT32, FLOAT64 -> decimal(number);
      case BYTE, CHAR, UINT8 -> String.valueOf(number.intValue() & 0xFF);
      case UINT16 -> String.valueOf(number.intValue() & 0xFFFF);
      case UINT32 -> Long.toString(number.longValue() & 0xFFFF_FFFFL);
      case UINT64 -> Long.toUnsignedString(number.longValue());
      default -> Long.toString(number.longValue());
    };
  }

  private static String decimal(Number number) {
    double value = number.doubleValue();
    if (Double.isNaN(value)) {
      return "\"nan\"";
    }
    return Double.isInfinite(value) ? value > 0 ? "\"inf\"" : "\"-inf\"" : number.toString();
  }

  private static String text(String text) {
    StringBuilder json = new StringBuilder("\"");
    for (int i = 0; i < text.length(); i++) {
      char each = text.charAt(i);
      if (each == '"' || each == '\\') {
        json.append('\\').append(each);
      } else if (each < ' '
          || each == '\u2028'
          || each == '\u2029'
          || Character.isSurrogate(each)) {
        json.append(String.format(Locale.ROOT, "\\u%04x", (int) each));
      } else {
        json.append(each);
      }
    }
    return json.append('"').toString();
  }
}

package dev.eventchain.messages;

import dev.eventchain.diagnostics.Sha256;
import java.util.Locale;
import java.util.StringJoiner;
import java.util.TreeMap;

/**
 * Hash by which ROS 2 nodes distinguish versions of a message type: SHA-256 of a description in
 * JSON (REP 2016; the kinds of fields are those of type_description_interfaces/msg/FieldType).
 */
final class TypeHash {

  private static final String VERSION = "RIHS01_";
  private static final int NESTED = 1;
  private static final int BOUNDED_STRING = 21;
  private static final int ARRAY = 48;
  private static final int BOUNDED_SEQUENCE = 96;
  private static final int SEQUENCE = 144;

  /** The member of an empty message, since an IDL struct needs one. */
  private static final FieldType PLACEHOLDER =
      new FieldType(FieldType.Kind.UINT8, java.util.Optional.empty(), FieldType.Shape.SINGLE, 0, 0);

  /** Descriptions of the referenced types, by name. */
  private final TreeMap<String, String> used = new TreeMap<>();

  private TypeHash() {}

  static String of(MessageType type) {
    TypeHash hash = new TypeHash();
    String own = hash.description(type);
    hash.used.remove(type.name());
    String text =
        "{\"type_description\": "
            + own
            + ", \"referenced_type_descriptions\": ["
            + String.join(", ", hash.used.values())
            + "]}";
    return VERSION + Sha256.of(text).hex();
  }

  private String description(MessageType type) {
    StringJoiner fields = new StringJoiner(", ", "[", "]");
    for (MessageType.Field field : type.fields()) {
      fields.add(field(field.name(), field.type()));
    }
    if (type.fields().isEmpty()) {
      fields.add(field("structure_needs_at_least_one_member", PLACEHOLDER));
    }
    return "{\"type_name\": \"" + type.name() + "\", \"fields\": " + fields + "}";
  }

  private String field(String name, FieldType type) {
    type.message().ifPresent(inner -> used.put(inner.name(), description(inner)));
    int capacity = type.shape() == FieldType.Shape.SINGLE ? 0 : type.size();
    return String.format(
        Locale.ROOT,
        "{\"name\": \"%s\", \"type\": {\"type_id\": %d, \"capacity\": %d,"
            + " \"string_capacity\": %d, \"nested_type_name\": \"%s\"}}",
        name,
        shape(type) + kind(type),
        capacity,
        type.stringBound(),
        type.message().map(MessageType::name).orElse(""));
  }

  private static int shape(FieldType type) {
    return switch (type.shape()) {
      case SINGLE -> 0;
      case ARRAY -> ARRAY;
      case SEQUENCE -> type.size() > 0 ? BOUNDED_SEQUENCE : SEQUENCE;
    };
  }

  private static int kind(FieldType type) {
    boolean bounded = type.stringBound() > 0;
    return switch (type.kind()) {
      case MESSAGE -> NESTED;
      case INT8 -> 2;
      case UINT8, CHAR -> 3; // char of a definition is uint8 in IDL
      case INT16 -> 4;
      case UINT16 -> 5;
      case INT32 -> 6;
      case UINT32 -> 7;
      case INT64 -> 8;
      case UINT64 -> 9;
      case FLOAT32 -> 10;
      case FLOAT64 -> 11;
      case BOOL -> 15;
      case BYTE -> 16;
      case STRING -> bounded ? BOUNDED_STRING : 17;
    };
  }
}

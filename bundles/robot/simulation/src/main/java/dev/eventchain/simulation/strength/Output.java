package dev.eventchain.simulation.strength;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.fault.OutputFault.Range;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * An output of a component: a field of a topic.
 *
 * @param node the component
 * @param topic the full name of the topic
 * @param message the message type
 * @param path the path of the field
 * @param kind the kind of its values
 * @param unit its unit; empty if it has none
 * @param safe its safe value; 0 if none is stated
 * @param range the range of its type
 * @param most the largest constant of an enumeration
 */
record Output(
    String node,
    String topic,
    MessageType message,
    String path,
    Kind kind,
    String unit,
    double safe,
    Range range,
    double most) {

  /** Kinds of fields. */
  enum Kind {
    /** A number. */
    NUMBER,
    /** An array of numbers. */
    NUMBERS,
    /** A Boolean. */
    TRUTH,
    /** An integer with constants for its values. */
    ENUMERATION,
    /** Anything else: only whole messages can be wrong. */
    OTHER;

    /** Returns whether it is a single value. */
    boolean isSingle() {
      return this == NUMBER || this == TRUTH || this == ENUMERATION;
    }
  }

  /** Time stamp and frame of a message, which are not what a component computes. */
  private static final String HEADER = "header.";

  /** Returns the outputs of a component whose types are known, without the headers of messages. */
  static List<Output> of(SoftwareNode node, MessageCatalog catalog) {
    return node.getOutput().stream()
        .flatMap(data -> of(node, data, catalog).stream())
        .filter(output -> !output.path().startsWith(HEADER))
        .toList();
  }

  private static Optional<Output> of(SoftwareNode node, Data data, MessageCatalog catalog) {
    Optional<String> topic = TopicIndex.nameOf(data, node);
    Optional<MessageType> message =
        Optional.ofNullable(data.getMessageType())
            .map(RosNames::fullMessageType)
            .flatMap(catalog::find);
    Optional<FieldType> field =
        message.flatMap(
            type ->
                Optional.ofNullable(data.getFieldName())
                    .flatMap(path -> type.resolve(path).type()));
    if (topic.isEmpty() || field.isEmpty()) {
      return Optional.empty();
    }
    List<Double> constants = constants(message.get(), data.getFieldName(), field.get());
    return Optional.of(
        new Output(
            node.getName(),
            topic.get(),
            message.get(),
            data.getFieldName(),
            kind(field.get(), !constants.isEmpty()),
            Objects.requireNonNullElse(data.getUnit(), ""),
            safe(data.getSafeValue()),
            range(field.get().kind()),
            constants.stream().mapToDouble(each -> each).max().orElse(0)));
  }

  /** Returns the integer constants of the message that has the field. */
  private static List<Double> constants(MessageType message, String path, FieldType field) {
    int dot = path.lastIndexOf('.');
    Optional<MessageType> owner =
        dot < 0
            ? Optional.of(message)
            : message.resolve(path.substring(0, dot)).type().flatMap(FieldType::message);
    return owner.stream()
        .flatMap(type -> type.constants().stream())
        .filter(constant -> isInteger(field.kind()) && constant.type().kind() == field.kind())
        .map(constant -> ((Number) constant.value()).doubleValue())
        .toList();
  }

  private static Kind kind(FieldType field, boolean hasConstants) {
    boolean single = field.shape() == FieldType.Shape.SINGLE;
    return switch (field.kind()) {
      case BOOL -> single ? Kind.TRUTH : Kind.OTHER;
      case STRING, MESSAGE, BYTE -> Kind.OTHER;
      default -> !single ? Kind.NUMBERS : hasConstants ? Kind.ENUMERATION : Kind.NUMBER;
    };
  }

  private static boolean isInteger(FieldType.Kind kind) {
    return switch (kind) {
      case CHAR, INT8, UINT8, INT16, UINT16, INT32, UINT32, INT64, UINT64 -> true;
      default -> false;
    };
  }

  private static double safe(String text) {
    if (text == null || text.isBlank() || text.trim().equals("false")) {
      return 0;
    }
    try {
      return text.trim().equals("true") ? 1 : Double.parseDouble(text.trim());
    } catch (NumberFormatException e) {
      return 0;
    }
  }

  private static Range range(FieldType.Kind kind) {
    return switch (kind) {
      case INT8 -> signed(8);
      case UINT8, CHAR -> unsigned(8);
      case INT16 -> signed(16);
      case UINT16 -> unsigned(16);
      case INT32 -> signed(32);
      case UINT32 -> unsigned(32);
      // The largest numbers of 64 bits that a double represents exactly.
      case INT64 -> signed(54);
      case UINT64 -> unsigned(53);
      case FLOAT32 -> new Range(-Float.MAX_VALUE, Float.MAX_VALUE);
      default -> new Range(-Double.MAX_VALUE, Double.MAX_VALUE);
    };
  }

  private static Range signed(int bits) {
    return new Range(-Math.pow(2, bits - 1), Math.pow(2, bits - 1) - 1);
  }

  private static Range unsigned(int bits) {
    return new Range(0, Math.pow(2, bits) - 1);
  }
}

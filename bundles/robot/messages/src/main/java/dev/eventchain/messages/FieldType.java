package dev.eventchain.messages;

import java.util.Locale;
import java.util.Optional;

/**
 * The type of a field.
 *
 * @param kind the primitive type, or {@link Kind#MESSAGE}
 * @param message the message type if the kind is {@link Kind#MESSAGE}
 * @param shape one value, a fixed number, or as many as there are
 * @param size how many values an array has; how many a sequence may have at most, 0 for any
 * @param stringBound how many bytes of UTF-8 a string may have at most, 0 for any
 */
public record FieldType(
    Kind kind, Optional<MessageType> message, Shape shape, int size, int stringBound) {

  /** Primitive types of the message language; {@code char} is {@code uint8} in ROS 2. */
  public enum Kind {
    /** true or false, one byte. */
    BOOL(1),
    /** An octet, 0 to 255. */
    BYTE(1),
    /** 0 to 255. */
    CHAR(1),
    /** Signed, one byte. */
    INT8(1),
    /** Unsigned, one byte. */
    UINT8(1),
    /** Signed, two bytes. */
    INT16(2),
    /** Unsigned, two bytes. */
    UINT16(2),
    /** Signed, four bytes. */
    INT32(4),
    /** Unsigned, four bytes. */
    UINT32(4),
    /** Signed, eight bytes. */
    INT64(8),
    /** Unsigned, eight bytes. */
    UINT64(8),
    /** IEEE 754 binary32. */
    FLOAT32(4),
    /** IEEE 754 binary64. */
    FLOAT64(8),
    /** UTF-8. */
    STRING(0),
    /** Another message. */
    MESSAGE(0);

    private final int bytes;

    Kind(int bytes) {
      this.bytes = bytes;
    }

    /** The size of a number, in bytes; 0 for what has no fixed size. */
    int bytes() {
      return bytes;
    }
  }

  /** How many values a field holds. */
  public enum Shape {
    /** One. */
    SINGLE,
    /** A fixed number, {@code float64[9]}. */
    ARRAY,
    /** Any number, {@code float64[]}, or up to a bound, {@code float64[<=9]}. */
    SEQUENCE
  }

  /** As the message language writes it, with the full name of a message. */
  @Override
  public String toString() {
    String base =
        message.map(MessageType::name).orElseGet(() -> kind.name().toLowerCase(Locale.ROOT));
    String bounded = stringBound > 0 ? base + "<=" + stringBound : base;
    return switch (shape) {
      case SINGLE -> bounded;
      case ARRAY -> bounded + "[" + size + "]";
      case SEQUENCE -> size > 0 ? bounded + "[<=" + size + "]" : bounded + "[]";
    };
  }
}

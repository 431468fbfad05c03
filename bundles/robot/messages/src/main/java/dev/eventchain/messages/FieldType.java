package dev.eventchain.messages;

import java.util.Locale;
import java.util.Optional;

/**
 * The type of a field.
 *
 * @param kind the primitive type, or {@link Kind#MESSAGE}
 * @param message the message type if the kind is {@link Kind#MESSAGE}
 * @param shape a single value, an array or a sequence
 * @param size length of an array; maximal length of a sequence, 0 if unbounded
 * @param stringBound maximal length of a string in bytes of UTF-8, 0 if unbounded
 */
public record FieldType(
    Kind kind, Optional<MessageType> message, Shape shape, int size, int stringBound) {

  /** Pattern of the types of single numbers, with those that other languages call otherwise. */
  public static final String NUMBER = "float(32|64)?|double|char|u?int(8|16|32|64)";

  /** Primitive types of the message language; {@code char} is {@code uint8} in ROS 2. */
  public enum Kind {
    /** True or false, one byte. */
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

    /** Returns the size of a number in bytes; 0 for types without a fixed size. */
    int bytes() {
      return bytes;
    }
  }

  /** Multiplicities of a field. */
  public enum Shape {
    /** A single value. */
    SINGLE,
    /** A fixed number of values, {@code float64[9]}. */
    ARRAY,
    /** Any number of values, {@code float64[]}, or up to a bound, {@code float64[<=9]}. */
    SEQUENCE
  }

  /** Returns the type in the syntax of the message language, with the full name of a message. */
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

package dev.eventchain.messages;

import java.lang.reflect.Array;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.DoubleConsumer;

/** Java representation of field values, see {@link MessageValue}. */
final class Values {

  private static final BigInteger TWO_TO_64 = BigInteger.ONE.shiftLeft(64);

  private Values() {}

  /** Returns the zero value: 0, false, empty, or a message of these. */
  static Object zero(FieldType type) {
    if (type.shape() == FieldType.Shape.SINGLE) {
      return switch (type.kind()) {
        case MESSAGE -> MessageValue.of(type.message().orElseThrow());
        case STRING -> "";
        case BOOL -> false;
        default -> number(type.kind(), BigInteger.ZERO);
      };
    }
    int length = type.shape() == FieldType.Shape.ARRAY ? type.size() : 0;
    if (isList(type.kind())) {
      List<Object> items = new ArrayList<>(length);
      FieldType element = element(type);
      for (int i = 0; i < length; i++) {
        items.add(zero(element));
      }
      return items;
    }
    return Array.newInstance(component(type.kind()), length);
  }

  /** Copies a default value for a new message, including arrays and lists. */
  static Object copy(Object value) {
    if (value instanceof List<?> list) {
      return new ArrayList<>(list);
    }
    if (!value.getClass().isArray()) {
      return value;
    }
    int length = Array.getLength(value);
    Object copy = Array.newInstance(value.getClass().getComponentType(), length);
    System.arraycopy(value, 0, copy, 0, length);
    return copy;
  }

  /** Returns whether several values are held in a list instead of an array of a primitive type. */
  static boolean isList(FieldType.Kind kind) {
    return kind.bytes() == 0;
  }

  static FieldType element(FieldType type) {
    return new FieldType(
        type.kind(), type.message(), FieldType.Shape.SINGLE, 0, type.stringBound());
  }

  static Class<?> component(FieldType.Kind kind) {
    return switch (kind) {
      case BOOL -> boolean.class;
      case BYTE, CHAR, INT8, UINT8 -> byte.class;
      case INT16, UINT16 -> short.class;
      case INT32, UINT32 -> int.class;
      case INT64, UINT64 -> long.class;
      case FLOAT32 -> float.class;
      case FLOAT64 -> double.class;
      default -> Object.class;
    };
  }

  /**
   * Converts a value to the representation of this type.
   *
   * @throws IllegalArgumentException if it does not fit, with a sentence that gives the reason
   */
  static Object coerce(FieldType type, Object value) {
    if (type.shape() == FieldType.Shape.SINGLE) {
      return single(type, value);
    }
    Object result = several(type, value);
    int length = result instanceof List<?> list ? list.size() : Array.getLength(result);
    boolean tooMany = type.size() > 0 && length > type.size();
    if (tooMany || (type.shape() == FieldType.Shape.ARRAY && length != type.size())) {
      throw new IllegalArgumentException(length + " values do not fit into " + type + ".");
    }
    return result;
  }

  private static Object several(FieldType type, Object value) {
    if (!isList(type.kind()) && value.getClass() == component(type.kind()).arrayType()) {
      return value;
    }
    if (!(value instanceof Collection<?> items)) {
      throw misfit(type, value);
    }
    FieldType element = element(type);
    if (isList(type.kind())) {
      List<Object> result = new ArrayList<>(items.size());
      items.forEach(item -> result.add(single(element, item)));
      return result;
    }
    Object result = Array.newInstance(component(type.kind()), items.size());
    int index = 0;
    for (Object item : items) {
      Array.set(result, index++, narrow(type.kind(), single(element, item)));
    }
    return result;
  }

  private static Object single(FieldType type, Object value) {
    return switch (type.kind()) {
      case MESSAGE -> message(type, value);
      case STRING -> text(type, value);
      case BOOL -> {
        if (!(value instanceof Boolean)) {
          throw misfit(type, value);
        }
        yield value;
      }
      default -> {
        if (!(value instanceof Number number)) {
          throw misfit(type, value);
        }
        yield number(type.kind(), number);
      }
    };
  }

  private static Object message(FieldType type, Object value) {
    if (value instanceof MessageValue message
        && message.type().name().equals(type.message().orElseThrow().name())) {
      return message;
    }
    throw misfit(type, value);
  }

  private static String text(FieldType type, Object value) {
    if (!(value instanceof String text)) {
      throw misfit(type, value);
    }
    int bound = type.stringBound();
    if (bound > 0 && text.getBytes(StandardCharsets.UTF_8).length > bound) {
      throw new IllegalArgumentException("A string of more than " + bound + " bytes: " + text);
    }
    return text;
  }

  private static Object number(FieldType.Kind kind, Number value) {
    if (kind == FieldType.Kind.FLOAT32) {
      return value.floatValue();
    }
    if (kind == FieldType.Kind.FLOAT64) {
      return value.doubleValue();
    }
    BigInteger exact = exact(kind, value);
    boolean signed = kind.name().startsWith("INT");
    int bits = kind.bytes() * 8;
    boolean fits =
        signed ? exact.bitLength() < bits : exact.signum() >= 0 && exact.bitLength() <= bits;
    if (!fits && !(kind == FieldType.Kind.UINT64 && value instanceof Long)) {
      throw new IllegalArgumentException(exact + " is out of the range of " + text(kind) + ".");
    }
    return bits == 64 || kind == FieldType.Kind.UINT32
        ? (Object) exact.longValue()
        : exact.intValue();
  }

  private static BigInteger exact(FieldType.Kind kind, Number value) {
    if (value instanceof BigInteger big) {
      return big;
    }
    if (value instanceof Double || value instanceof Float || value instanceof BigDecimal) {
      try {
        return new BigDecimal(value.toString()).toBigIntegerExact();
      } catch (ArithmeticException | NumberFormatException e) {
        throw new IllegalArgumentException(value + " is not an integer of " + text(kind) + ".", e);
      }
    }
    return BigInteger.valueOf(value.longValue());
  }

  /** Converts an element of a Java array: unsigned numbers keep their bits. */
  private static Object narrow(FieldType.Kind kind, Object value) {
    if (!(value instanceof Number number)) {
      return value;
    }
    return switch (kind.bytes()) {
      case 1 -> number.byteValue();
      case 2 -> number.shortValue();
      default -> component(kind) == int.class ? (Object) number.intValue() : number;
    };
  }

  /** Passes on the elements of a Java array of numbers or Booleans, in order. */
  static void forEachNumber(FieldType.Kind kind, Object array, DoubleConsumer consumer) {
    // Scans and images have many: they are not boxed.
    if (array instanceof byte[] bytes) {
      int mask = kind == FieldType.Kind.INT8 ? -1 : 0xff;
      for (byte each : bytes) {
        consumer.accept(each & mask);
      }
    } else if (array instanceof float[] floats) {
      for (float each : floats) {
        consumer.accept(each);
      }
    } else {
      int length = Array.getLength(array);
      for (int i = 0; i < length; i++) {
        consumer.accept(number(kind, Array.get(array, i)));
      }
    }
  }

  private static double number(FieldType.Kind kind, Object element) {
    return switch (kind) {
      case BOOL -> (Boolean) element ? 1.0 : 0.0;
      case UINT16 -> Short.toUnsignedInt((Short) element);
      case UINT32 -> Integer.toUnsignedLong((Integer) element);
      case UINT64 -> unsigned((Long) element).doubleValue();
      default -> ((Number) element).doubleValue();
    };
  }

  /** Returns the exact value of an unsigned number of 64 bits. */
  static BigInteger unsigned(long bits) {
    BigInteger value = BigInteger.valueOf(bits);
    return bits < 0 ? value.add(TWO_TO_64) : value;
  }

  private static String text(FieldType.Kind kind) {
    return kind.name().toLowerCase(java.util.Locale.ROOT);
  }

  private static IllegalArgumentException misfit(FieldType type, Object value) {
    return new IllegalArgumentException(
        "A value of " + value.getClass().getSimpleName() + " does not fit into " + type + ".");
  }
}

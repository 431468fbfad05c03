package dev.eventchain.messages;

import java.util.Arrays;
import java.util.StringJoiner;
import java.util.function.DoubleConsumer;

/**
 * A message. Fields hold
 *
 * <ul>
 *   <li>{@link Boolean}; {@link Integer} for integers up to 32 bits, {@link Long} for {@code
 *       uint32}, {@code int64} and {@code uint64} (its bits); {@link Float}, {@link Double}; {@link
 *       String}; {@link MessageValue};
 *   <li>arrays and sequences of numbers and Booleans as Java arrays of the same width ({@code
 *       byte[]} for {@code uint8[]}, {@code float[]} for {@code float32[]}), which are not copied;
 *   <li>arrays and sequences of strings and messages as {@link java.util.List}.
 * </ul>
 *
 * Mutable; not thread-safe.
 */
public final class MessageValue {

  private final MessageType type;
  private final Object[] values;

  MessageValue(MessageType type, Object[] values) {
    this.type = type;
    this.values = values;
  }

  /** Returns a message with the default values of its type. */
  public static MessageValue of(MessageType type) {
    Object[] values = new Object[type.fields().size()];
    for (int i = 0; i < values.length; i++) {
      MessageType.Field field = type.fields().get(i);
      values[i] = field.defaultValue().map(Values::copy).orElseGet(() -> Values.zero(field.type()));
    }
    return new MessageValue(type, values);
  }

  /** Returns the type. */
  public MessageType type() {
    return type;
  }

  /**
   * Returns the value of a field.
   *
   * @param path a field or a nested field: {@code header.stamp.sec}
   * @throws IllegalArgumentException if there is no such field
   */
  public Object get(String path) {
    MessageValue owner = owner(path);
    return owner.values[owner.index(path.substring(path.lastIndexOf('.') + 1))];
  }

  /**
   * Returns the value of a numeric field; unsigned numbers as non-negative values.
   *
   * @throws IllegalArgumentException if there is no such field, or it is not a number
   */
  public double number(String path) {
    MessageValue owner = owner(path);
    int index = owner.index(path.substring(path.lastIndexOf('.') + 1));
    if (!(owner.values[index] instanceof Number number)) {
      throw new IllegalArgumentException("'" + path + "' of " + type + " is not a number.");
    }
    boolean unsigned = owner.type.fields().get(index).type().kind() == FieldType.Kind.UINT64;
    return unsigned ? Values.unsigned(number.longValue()).doubleValue() : number.doubleValue();
  }

  /**
   * Passes on the elements of an array or a sequence of numbers or Booleans, in order; unsigned
   * numbers as non-negative values, Booleans as 1 and 0.
   *
   * @throws IllegalArgumentException if there is no such field, or it does not hold several numbers
   */
  public void forEachNumber(String path, DoubleConsumer consumer) {
    MessageValue owner = owner(path);
    int index = owner.index(path.substring(path.lastIndexOf('.') + 1));
    Object elements = owner.values[index];
    if (!elements.getClass().isArray()) {
      throw new IllegalArgumentException("'" + path + "' of " + type + " has no numbers.");
    }
    Values.forEachNumber(owner.type.fields().get(index).type().kind(), elements, consumer);
  }

  /**
   * Sets a field.
   *
   * @param value a value in the representation of the field, or any {@link Number} that fits, or a
   *     collection of these
   * @return this
   * @throws IllegalArgumentException if there is no such field, or the value does not fit
   */
  public MessageValue set(String path, Object value) {
    MessageValue owner = owner(path);
    int index = owner.index(path.substring(path.lastIndexOf('.') + 1));
    try {
      owner.values[index] = Values.coerce(owner.type.fields().get(index).type(), value);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("'" + path + "' of " + type + ": " + e.getMessage(), e);
    }
    return this;
  }

  /** Returns the value of a field by position. */
  Object at(int index) {
    return values[index];
  }

  private MessageValue owner(String path) {
    MessageValue current = this;
    int start = 0;
    for (int dot = path.indexOf('.'); dot >= 0; dot = path.indexOf('.', start)) {
      Object value = current.values[current.index(path.substring(start, dot))];
      if (!(value instanceof MessageValue next)) {
        throw new IllegalArgumentException(type.resolve(path).problem());
      }
      current = next;
      start = dot + 1;
    }
    return current;
  }

  private int index(String field) {
    int index = type.indexOf(field);
    if (index < 0) {
      throw new IllegalArgumentException(type.resolve(field).problem());
    }
    return index;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof MessageValue that
        && type.name().equals(that.type.name())
        && Arrays.deepEquals(values, that.values);
  }

  @Override
  public int hashCode() {
    return Arrays.deepHashCode(values);
  }

  @Override
  public String toString() {
    StringJoiner text = new StringJoiner(", ", type.name() + "(", ")");
    for (int i = 0; i < values.length; i++) {
      String value = Arrays.deepToString(new Object[] {values[i]});
      text.add(type.fields().get(i).name() + "=" + value.substring(1, value.length() - 1));
    }
    return text.toString();
  }
}

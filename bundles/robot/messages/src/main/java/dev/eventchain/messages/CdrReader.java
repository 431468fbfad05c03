package dev.eventchain.messages;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Reads one message as CDR. */
final class CdrReader {

  /** Messages on the wire are padded to a multiple of this, in bytes. */
  private static final int PADDED = 4;

  private final ByteBuffer buffer;
  private final int start;

  CdrReader(byte[] bytes, int offset, int length) {
    buffer = ByteBuffer.wrap(bytes, offset, length);
    start = offset + CdrWriter.HEADER;
  }

  MessageValue read(MessageType type) {
    try {
      readHeader();
      return message(type);
    } catch (BufferUnderflowException e) {
      throw tooShort(type);
    }
  }

  void requireMessage(MessageType type) {
    try {
      readHeader();
      skip(type);
    } catch (BufferUnderflowException e) {
      throw tooShort(type);
    }
    if (buffer.remaining() >= PADDED) {
      throw new IllegalArgumentException(
          String.format(Locale.ROOT, "%d bytes follow the message %s.", buffer.remaining(), type));
    }
  }

  private void readHeader() {
    int representation = buffer.getShort();
    buffer.getShort();
    if (representation != 0 && representation != 1) {
      throw new IllegalArgumentException(
          "Representation " + representation + " is not plain CDR (0 or 1).");
    }
    buffer.order(representation == 1 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
  }

  private static IllegalArgumentException tooShort(MessageType type) {
    return new IllegalArgumentException("The bytes end before the message " + type + " does.");
  }

  private MessageValue message(MessageType type) {
    List<MessageType.Field> fields = type.fields();
    if (fields.isEmpty()) {
      buffer.get();
    }
    Object[] values = new Object[fields.size()];
    for (int i = 0; i < values.length; i++) {
      FieldType field = fields.get(i).type();
      values[i] = field.shape() == FieldType.Shape.SINGLE ? single(field) : several(field);
    }
    return new MessageValue(type, values);
  }

  private Object single(FieldType type) {
    return switch (type.kind()) {
      case MESSAGE -> message(type.message().orElseThrow());
      case STRING -> string();
      case BOOL -> buffer.get() != 0;
      case INT8 -> (int) buffer.get();
      case BYTE, CHAR, UINT8 -> buffer.get() & 0xFF;
      case INT16 -> (int) align(2).getShort();
      case UINT16 -> align(2).getShort() & 0xFFFF;
      case INT32 -> align(4).getInt();
      case UINT32 -> align(4).getInt() & 0xFFFFFFFFL;
      case INT64, UINT64 -> align(8).getLong();
      case FLOAT32 -> align(4).getFloat();
      case FLOAT64 -> align(8).getDouble();
    };
  }

  private String string() {
    int length = align(4).getInt();
    if (length < 0 || length > buffer.remaining()) {
      throw new BufferUnderflowException();
    }
    if (length == 0) {
      return ""; // not allowed, but written by some writers
    }
    ByteBuffer text = buffer.slice(buffer.position(), length - 1);
    buffer.position(buffer.position() + length);
    try {
      return StandardCharsets.UTF_8.newDecoder().decode(text).toString();
    } catch (CharacterCodingException e) {
      throw new IllegalArgumentException("A string is not UTF-8.", e);
    }
  }

  private void skip(MessageType type) {
    if (type.fields().isEmpty()) {
      skip(1, 1);
    }
    for (MessageType.Field field : type.fields()) {
      FieldType each = field.type();
      int count = each.shape() == FieldType.Shape.SINGLE ? 1 : count(each);
      if (!Values.isList(each.kind())) {
        skip(each.kind().bytes(), count);
        if (each.kind() == FieldType.Kind.BOOL) {
          requireTruthValues(count);
        }
        continue;
      }
      for (int i = 0; i < count; i++) {
        if (each.kind() == FieldType.Kind.MESSAGE) {
          skip(each.message().orElseThrow());
        } else {
          skip(1, count(align(4).getInt(), 1));
        }
      }
    }
  }

  private void skip(int size, int count) {
    if (count > 0) {
      align(size);
      int bytes = Math.multiplyExact(size, count(count, size));
      buffer.position(buffer.position() + bytes);
    }
  }

  /** Checks that the preceding bytes are Booleans, 0 or 1. */
  private void requireTruthValues(int count) {
    for (int i = buffer.position() - count; i < buffer.position(); i++) {
      if ((buffer.get(i) & ~1) != 0) {
        throw new IllegalArgumentException("A bool is 0 or 1, not " + (buffer.get(i) & 0xFF) + ".");
      }
    }
  }

  /** Returns the number of values of an array or a sequence. */
  private int count(FieldType type) {
    boolean array = type.shape() == FieldType.Shape.ARRAY;
    // A string or a message takes at least one byte, so a wrong count fails here before memory is
    // allocated.
    int count = count(array ? type.size() : align(4).getInt(), Math.max(1, type.kind().bytes()));
    if (!array && type.size() > 0 && count > type.size()) {
      throw new IllegalArgumentException(count + " values do not fit into " + type + ".");
    }
    return count;
  }

  private int count(int count, int size) {
    if (count < 0 || (long) count * size > buffer.remaining()) {
      throw new BufferUnderflowException();
    }
    return count;
  }

  private Object several(FieldType type) {
    int count = count(type);
    if (!Values.isList(type.kind())) {
      return numbers(type.kind(), count);
    }
    List<Object> values = new ArrayList<>(count);
    FieldType element = Values.element(type);
    for (int i = 0; i < count; i++) {
      values.add(single(element));
    }
    return values;
  }

  private Object numbers(FieldType.Kind kind, int count) {
    Object result = java.lang.reflect.Array.newInstance(Values.component(kind), count);
    if (count == 0) {
      return result;
    }
    int bytes = kind.bytes();
    align(bytes);
    int end = Math.addExact(buffer.position(), bytes * count);
    if (end > buffer.limit()) {
      throw new BufferUnderflowException();
    }
    ByteBuffer rest = buffer.slice().order(buffer.order());
    if (result instanceof byte[] array) {
      rest.get(array);
    } else if (result instanceof float[] array) {
      rest.asFloatBuffer().get(array);
    } else if (result instanceof double[] array) {
      rest.asDoubleBuffer().get(array);
    } else if (result instanceof int[] array) {
      rest.asIntBuffer().get(array);
    } else if (result instanceof long[] array) {
      rest.asLongBuffer().get(array);
    } else if (result instanceof short[] array) {
      rest.asShortBuffer().get(array);
    } else if (result instanceof boolean[] array) {
      for (int i = 0; i < count; i++) {
        array[i] = rest.get(i) != 0;
      }
    }
    buffer.position(end);
    return result;
  }

  private ByteBuffer align(int alignment) {
    int padding = -(buffer.position() - start) & (alignment - 1);
    if (padding > buffer.remaining()) {
      throw new BufferUnderflowException();
    }
    return buffer.position(buffer.position() + padding);
  }
}

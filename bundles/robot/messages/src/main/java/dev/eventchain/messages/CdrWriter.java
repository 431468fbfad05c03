package dev.eventchain.messages;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/** Writes one message as little-endian CDR. */
final class CdrWriter {

  static final int HEADER = 4;

  private byte[] bytes = {0, 1, 0, 0};
  private ByteBuffer buffer = ByteBuffer.wrap(bytes).position(HEADER);

  byte[] toBytes() {
    return Arrays.copyOf(bytes, buffer.position());
  }

  void write(MessageValue message) {
    List<MessageType.Field> fields = message.type().fields();
    if (fields.isEmpty()) {
      reserve(1, 1).put((byte) 0); // a struct of IDL needs a member (rosidl)
    }
    for (int i = 0; i < fields.size(); i++) {
      FieldType type = fields.get(i).type();
      if (type.shape() == FieldType.Shape.SINGLE) {
        single(type.kind(), message.at(i));
      } else {
        several(type, message.at(i));
      }
    }
  }

  private void single(FieldType.Kind kind, Object value) {
    switch (kind) {
      case MESSAGE -> write((MessageValue) value);
      case STRING -> string((String) value);
      case BOOL -> reserve(1, 1).put((byte) ((Boolean) value ? 1 : 0));
      case FLOAT32 -> reserve(4, 4).putFloat((Float) value);
      case FLOAT64 -> reserve(8, 8).putDouble((Double) value);
      default -> integer(kind.bytes(), ((Number) value).longValue());
    }
  }

  private void integer(int size, long value) {
    ByteBuffer target = reserve(size, size);
    switch (size) {
      case 1 -> target.put((byte) value);
      case 2 -> target.putShort((short) value);
      case 4 -> target.putInt((int) value);
      default -> target.putLong(value);
    }
  }

  private void string(String value) {
    byte[] text = value.getBytes(StandardCharsets.UTF_8);
    integer(4, text.length + 1L);
    reserve(1, text.length + 1).put(text).put((byte) 0);
  }

  private void several(FieldType type, Object values) {
    if (values instanceof List<?> list) {
      count(type, list.size());
      list.forEach(value -> single(type.kind(), value));
    } else {
      count(type, java.lang.reflect.Array.getLength(values));
      numbers(type.kind().bytes(), values);
    }
  }

  private void count(FieldType type, int count) {
    if (type.shape() == FieldType.Shape.SEQUENCE) {
      integer(4, count);
    }
  }

  private void numbers(int size, Object values) {
    int length = java.lang.reflect.Array.getLength(values);
    if (length == 0) {
      return; // no padding for an empty sequence
    }
    ByteBuffer target = reserve(size, Math.multiplyExact(size, length));
    if (values instanceof byte[] array) {
      target.put(array);
      return;
    }
    ByteBuffer rest = target.slice().order(ByteOrder.LITTLE_ENDIAN);
    if (values instanceof float[] array) {
      rest.asFloatBuffer().put(array);
    } else if (values instanceof double[] array) {
      rest.asDoubleBuffer().put(array);
    } else if (values instanceof int[] array) {
      rest.asIntBuffer().put(array);
    } else if (values instanceof long[] array) {
      rest.asLongBuffer().put(array);
    } else if (values instanceof short[] array) {
      rest.asShortBuffer().put(array);
    } else if (values instanceof boolean[] array) {
      for (boolean value : array) {
        rest.put((byte) (value ? 1 : 0));
      }
    }
    target.position(target.position() + size * length);
  }

  /** Aligns relative to the end of the header, and reserves space. */
  private ByteBuffer reserve(int alignment, int count) {
    int start = buffer.position();
    int padding = -(start - HEADER) & (alignment - 1);
    int needed = Math.addExact(start + padding, count);
    if (needed > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(needed + 512, bytes.length * 2));
      buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }
    return buffer.position(start + padding); // new bytes are zero, as padding has to be
  }
}

package dev.eventchain.simulation;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Writes CDR version 1, little-endian, with its encapsulation header: the fields one by one. */
final class CdrWriter {

  private static final int HEADER = 4;

  private ByteBuffer buffer;

  CdrWriter(int capacity) {
    buffer = allocate(HEADER + capacity);
    buffer.put(new byte[] {0, 1, 0, 0});
  }

  private static ByteBuffer allocate(int capacity) {
    return ByteBuffer.allocate(capacity).order(ByteOrder.LITTLE_ENDIAN);
  }

  private void align(int size, int needed) {
    int padding = Math.floorMod(-(buffer.position() - HEADER), size);
    if (buffer.remaining() < padding + needed) {
      ByteBuffer larger = allocate(2 * buffer.capacity() + padding + needed);
      buffer = larger.put(buffer.flip());
    }
    for (int i = 0; i < padding; i++) {
      buffer.put((byte) 0);
    }
  }

  CdrWriter uint8(int value) {
    align(1, 1);
    buffer.put((byte) value);
    return this;
  }

  CdrWriter bool(boolean value) {
    return uint8(value ? 1 : 0);
  }

  CdrWriter int32(int value) {
    align(4, 4);
    buffer.putInt(value);
    return this;
  }

  CdrWriter float32(double value) {
    align(4, 4);
    buffer.putFloat((float) value);
    return this;
  }

  CdrWriter float64(double... values) {
    for (double value : values) {
      align(8, 8);
      buffer.putDouble(value);
    }
    return this;
  }

  CdrWriter string(String value) {
    byte[] bytes = value.getBytes(StandardCharsets.UTF_8);
    int32(bytes.length + 1);
    align(1, bytes.length + 1);
    buffer.put(bytes).put((byte) 0);
    return this;
  }

  /** A sequence of octets. */
  CdrWriter bytes(byte[] value) {
    int32(value.length);
    align(1, value.length);
    buffer.put(value);
    return this;
  }

  /** {@code builtin_interfaces/Time} of a time in ns. */
  CdrWriter time(long nanoseconds) {
    return int32((int) (nanoseconds / 1_000_000_000L)).int32((int) (nanoseconds % 1_000_000_000L));
  }

  /** What was written. */
  ByteBuffer finish() {
    return buffer.flip();
  }
}

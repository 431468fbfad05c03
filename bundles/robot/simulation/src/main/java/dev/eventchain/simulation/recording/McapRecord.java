package dev.eventchain.simulation.recording;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;

/**
 * One record of an MCAP file under construction: an opcode, a length, and fields. All numbers are
 * little-endian; texts, byte arrays, maps and arrays are prefixed with their length in bytes.
 */
final class McapRecord {

  static final int HEADER = 0x01;
  static final int FOOTER = 0x02;
  static final int SCHEMA = 0x03;
  static final int CHANNEL = 0x04;
  static final int MESSAGE = 0x05;
  static final int CHUNK = 0x06;
  static final int MESSAGE_INDEX = 0x07;
  static final int CHUNK_INDEX = 0x08;
  static final int STATISTICS = 0x0B;
  static final int METADATA = 0x0C;
  static final int METADATA_INDEX = 0x0D;
  static final int SUMMARY_OFFSET = 0x0E;
  static final int DATA_END = 0x0F;

  /** Length of the opcode and the length field. */
  static final int HEAD = 1 + Long.BYTES;

  private ByteBuffer buffer = ByteBuffer.allocate(256).order(ByteOrder.LITTLE_ENDIAN);

  McapRecord(int opcode) {
    buffer.put((byte) opcode).putLong(0);
  }

  private ByteBuffer room(int bytes) {
    if (buffer.remaining() < bytes) {
      int length = Math.max(2 * buffer.capacity(), Math.addExact(buffer.position(), bytes));
      ByteBuffer larger = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
      buffer = larger.put(buffer.flip());
    }
    return buffer;
  }

  McapRecord u8(int value) {
    room(Byte.BYTES).put((byte) value);
    return this;
  }

  McapRecord u16(int value) {
    room(Short.BYTES).putShort((short) value);
    return this;
  }

  McapRecord u32(long value) {
    room(Integer.BYTES).putInt((int) value);
    return this;
  }

  McapRecord u64(long value) {
    room(Long.BYTES).putLong(value);
    return this;
  }

  /** Appends bytes without a length prefix. */
  McapRecord raw(ByteBuffer bytes) {
    room(bytes.remaining()).put(bytes.duplicate());
    return this;
  }

  McapRecord text(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return u32(bytes.length).raw(ByteBuffer.wrap(bytes));
  }

  McapRecord texts(Map<String, String> texts) {
    return sized(() -> texts.forEach((key, value) -> text(key).text(value)));
  }

  /** Appends a map from channel ids to numbers. */
  McapRecord numbers(Map<Integer, Long> numbers) {
    return sized(() -> numbers.forEach((id, value) -> u16(id).u64(value)));
  }

  /** Appends the content that some calls write, prefixed with its length. */
  McapRecord sized(Runnable content) {
    u32(0);
    int start = buffer.position();
    content.run();
    buffer.putInt(start - Integer.BYTES, buffer.position() - start);
    return this;
  }

  /** Returns the complete record. */
  byte[] bytes() {
    buffer.putLong(1, buffer.position() - HEAD);
    return Arrays.copyOf(buffer.array(), buffer.position());
  }
}

package dev.eventchain.workspace;

import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The summary at the end of an MCAP file (format version 0): its schemas, channels and statistics.
 * The messages are not read, so that neither the size of the file nor its compression matters.
 */
final class McapSummary {

  private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
  private static final int HEAD = 1 + Long.BYTES;
  private static final int FOOTER_LENGTH = HEAD + 2 * Long.BYTES + Integer.BYTES;
  private static final int MOST = 64 << 20;
  private static final int FOOTER = 0x02;
  private static final int SCHEMA = 0x03;
  private static final int CHANNEL = 0x04;
  private static final int STATISTICS = 0x0B;

  /** A message type, with its definition. */
  record Schema(String name, String encoding, String definition) {}

  /** The messages of a topic. */
  record Channel(int id, int schema, String topic, String encoding, Map<String, String> metadata) {}

  private final Map<Integer, Schema> schemas = new LinkedHashMap<>();
  private final Map<Integer, Channel> channels = new LinkedHashMap<>();
  private final Map<Integer, Long> counts = new LinkedHashMap<>();
  private long nanoseconds;

  private McapSummary() {}

  /** Reads the summary of a file. */
  static McapSummary read(Path file) throws IOException, MalformedFileException {
    McapSummary summary = new McapSummary();
    try (FileChannel channel = FileChannel.open(file)) {
      ByteBuffer bytes = summaryOf(channel);
      while (bytes.remaining() >= HEAD) {
        int kind = Byte.toUnsignedInt(bytes.get());
        long length = bytes.getLong();
        if (length < 0 || length > bytes.remaining()) {
          throw new MalformedFileException("a record of its summary is cut off");
        }
        summary.add(kind, next(bytes, (int) length));
      }
    } catch (BufferUnderflowException e) {
      throw new MalformedFileException("a record of its summary is cut off");
    }
    return summary;
  }

  private static ByteBuffer summaryOf(FileChannel file) throws IOException, MalformedFileException {
    long size = file.size();
    if (size < 2L * MAGIC.length + FOOTER_LENGTH
        || !Arrays.equals(part(file, 0, MAGIC.length).array(), MAGIC)) {
      throw new MalformedFileException("it is no MCAP file");
    }
    long footer = size - MAGIC.length - FOOTER_LENGTH;
    ByteBuffer end = part(file, footer, FOOTER_LENGTH);
    if (!Arrays.equals(part(file, size - MAGIC.length, MAGIC.length).array(), MAGIC)
        || end.get() != FOOTER) {
      throw new MalformedFileException("it has no end; 'mcap recover' makes one");
    }
    long start = end.getLong(HEAD);
    if (start == 0) {
      throw new MalformedFileException("it has no summary; 'mcap recover' makes one");
    }
    if (start < 0 || start > footer || footer - start > MOST) {
      throw new MalformedFileException("its summary is not where it says");
    }
    return part(file, start, (int) (footer - start));
  }

  private static ByteBuffer part(FileChannel file, long from, int length) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
    while (bytes.hasRemaining() && file.read(bytes, from + bytes.position()) >= 0) {
      // until it is full, or the file ends
    }
    return bytes.flip();
  }

  private static ByteBuffer next(ByteBuffer bytes, int length) {
    if (length < 0 || length > bytes.remaining()) {
      throw new BufferUnderflowException();
    }
    ByteBuffer part = bytes.slice(bytes.position(), length).order(ByteOrder.LITTLE_ENDIAN);
    bytes.position(bytes.position() + length);
    return part;
  }

  private static String text(ByteBuffer bytes) {
    return StandardCharsets.UTF_8.decode(next(bytes, bytes.getInt())).toString();
  }

  private void add(int kind, ByteBuffer record) {
    if (kind == SCHEMA) {
      int id = Short.toUnsignedInt(record.getShort());
      schemas.put(id, new Schema(text(record), text(record), text(record)));
    } else if (kind == CHANNEL) {
      int id = Short.toUnsignedInt(record.getShort());
      int schema = Short.toUnsignedInt(record.getShort());
      String topic = text(record);
      String encoding = text(record);
      Map<String, String> metadata = new LinkedHashMap<>();
      for (ByteBuffer map = next(record, record.getInt()); map.hasRemaining(); ) {
        metadata.put(text(map), text(map));
      }
      channels.put(id, new Channel(id, schema, topic, encoding, metadata));
    } else if (kind == STATISTICS) {
      statistics(record);
    }
  }

  private void statistics(ByteBuffer record) {
    record.getLong();
    record.getShort();
    for (int i = 0; i < 4; i++) {
      record.getInt();
    }
    long first = record.getLong();
    nanoseconds = record.getLong() - first;
    for (ByteBuffer map = next(record, record.getInt()); map.hasRemaining(); ) {
      counts.put(Short.toUnsignedInt(map.getShort()), map.getLong());
    }
  }

  Iterable<Channel> channels() {
    return channels.values();
  }

  Optional<Schema> schema(Channel channel) {
    return Optional.ofNullable(schemas.get(channel.schema()));
  }

  /** Returns the number of messages of a channel. */
  long count(Channel channel) {
    return counts.getOrDefault(channel.id(), 0L);
  }

  /** Returns the seconds from the first message to the last one. */
  double duration() {
    return nanoseconds / 1e9;
  }
}

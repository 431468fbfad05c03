package dev.eventchain.simulation.recording;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.zip.CRC32;

/**
 * Writes an MCAP file (format version 0, profile ros2) sequentially: messages in uncompressed
 * chunks, an index after each chunk, and a summary at the end. Holds one chunk in memory, and some
 * bytes for each written one.
 */
final class McapWriter {

  private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

  /** Length at which a chunk is written. */
  private static final int CHUNK_LENGTH = 1 << 20;

  private final OutputStream output;
  private final CRC32 crc = new CRC32();
  private final Map<List<String>, Integer> schemas = new LinkedHashMap<>();
  private final List<byte[]> schemaRecords = new ArrayList<>();
  private final List<byte[]> channelRecords = new ArrayList<>();
  private final List<byte[]> chunkIndexes = new ArrayList<>();
  private final List<byte[]> metadataIndexes = new ArrayList<>();
  private final SortedMap<Integer, Long> counts = new TreeMap<>();
  private final ByteArrayOutputStream chunk = new ByteArrayOutputStream();
  private final SortedMap<Integer, List<long[]>> index = new TreeMap<>();
  private long position;
  private long chunkFirst;
  private long chunkLast;
  private long first;
  private long last;

  /**
   * Begins a file.
   *
   * @param output the stream, which stays open
   */
  McapWriter(OutputStream output) throws IOException {
    this.output = output;
    write(MAGIC);
    write(new McapRecord(McapRecord.HEADER).text("ros2").text("eventchain").bytes());
  }

  private void write(byte[] bytes) throws IOException {
    output.write(bytes);
    crc.update(bytes);
    position += bytes.length;
  }

  /**
   * Adds a channel for the messages of one type on a topic.
   *
   * @param type the full name of the message type
   * @param definition its definition, with those of the types that it uses
   * @return the id of the channel
   */
  int channel(String topic, String type, String definition) throws IOException {
    Integer schema = schemas.get(List.of(type, definition));
    if (schema == null) {
      schema = schemas.size() + 1;
      schemas.put(List.of(type, definition), schema);
      McapRecord record = new McapRecord(McapRecord.SCHEMA).u16(schema);
      schemaRecords.add(record.text(type).text("ros2msg").text(definition).bytes());
      write(schemaRecords.get(schemaRecords.size() - 1));
    }
    int id = channelRecords.size();
    McapRecord record = new McapRecord(McapRecord.CHANNEL).u16(id).u16(schema);
    record.text(topic).text("cdr").texts(Map.of("offered_qos_profiles", ""));
    channelRecords.add(record.bytes());
    write(record.bytes());
    return id;
  }

  /**
   * Adds a message.
   *
   * @param time publication time, in ns; ascending order is preferred, for efficient reading
   */
  void message(int channel, long time, ByteBuffer message) throws IOException {
    chunkFirst = chunk.size() == 0 ? time : Math.min(chunkFirst, time);
    chunkLast = chunk.size() == 0 ? time : Math.max(chunkLast, time);
    first = counts.isEmpty() ? time : Math.min(first, time);
    last = Math.max(last, time);
    long sequence = counts.merge(channel, 1L, Long::sum) - 1;
    index.computeIfAbsent(channel, id -> new ArrayList<>()).add(new long[] {time, chunk.size()});
    McapRecord record = new McapRecord(McapRecord.MESSAGE).u16(channel).u32(sequence);
    chunk.writeBytes(record.u64(time).u64(time).raw(message).bytes());
    if (chunk.size() >= CHUNK_LENGTH) {
      endChunk();
    }
  }

  private void endChunk() throws IOException {
    if (chunk.size() == 0) {
      return;
    }
    byte[] records = chunk.toByteArray();
    CRC32 checksum = new CRC32();
    checksum.update(records);
    long start = position;
    McapRecord record = new McapRecord(McapRecord.CHUNK).u64(chunkFirst).u64(chunkLast);
    record.u64(records.length).u32(checksum.getValue()).text("").u64(records.length);
    write(record.raw(ByteBuffer.wrap(records)).bytes());
    long length = position - start;
    SortedMap<Integer, Long> offsets = new TreeMap<>();
    for (Map.Entry<Integer, List<long[]>> entry : index.entrySet()) {
      offsets.put(entry.getKey(), position);
      McapRecord messages = new McapRecord(McapRecord.MESSAGE_INDEX).u16(entry.getKey());
      messages.sized(() -> entry.getValue().forEach(at -> messages.u64(at[0]).u64(at[1])));
      write(messages.bytes());
    }
    McapRecord chunkIndex = new McapRecord(McapRecord.CHUNK_INDEX).u64(chunkFirst).u64(chunkLast);
    chunkIndex.u64(start).u64(length).numbers(offsets).u64(position - start - length);
    chunkIndexes.add(chunkIndex.text("").u64(records.length).u64(records.length).bytes());
    chunk.reset();
    index.clear();
  }

  /** Adds metadata of the file. */
  void metadata(String name, SortedMap<String, String> values) throws IOException {
    endChunk();
    long start = position;
    write(new McapRecord(McapRecord.METADATA).text(name).texts(values).bytes());
    McapRecord record = new McapRecord(McapRecord.METADATA_INDEX).u64(start);
    metadataIndexes.add(record.u64(position - start).text(name).bytes());
  }

  /** Writes the summary, which completes the file. */
  void finish() throws IOException {
    endChunk();
    write(new McapRecord(McapRecord.DATA_END).u32(crc.getValue()).bytes());
    crc.reset();
    long summary = position;
    List<byte[]> offsets = new ArrayList<>();
    group(McapRecord.SCHEMA, schemaRecords, offsets);
    group(McapRecord.CHANNEL, channelRecords, offsets);
    group(McapRecord.STATISTICS, List.of(statistics()), offsets);
    group(McapRecord.METADATA_INDEX, metadataIndexes, offsets);
    group(McapRecord.CHUNK_INDEX, chunkIndexes, offsets);
    long offsetsStart = position;
    for (byte[] offset : offsets) {
      write(offset);
    }
    byte[] footer = new McapRecord(McapRecord.FOOTER).u64(summary).u64(offsetsStart).u32(0).bytes();
    int beforeChecksum = footer.length - Integer.BYTES;
    crc.update(footer, 0, beforeChecksum);
    ByteBuffer.wrap(footer)
        .order(ByteOrder.LITTLE_ENDIAN)
        .putInt(beforeChecksum, (int) crc.getValue());
    write(footer);
    write(MAGIC);
  }

  private void group(int opcode, List<byte[]> records, List<byte[]> offsets) throws IOException {
    if (records.isEmpty()) {
      return;
    }
    long start = position;
    for (byte[] record : records) {
      write(record);
    }
    McapRecord offset = new McapRecord(McapRecord.SUMMARY_OFFSET).u8(opcode).u64(start);
    offsets.add(offset.u64(position - start).bytes());
  }

  private byte[] statistics() {
    long messages = counts.values().stream().mapToLong(Long::longValue).sum();
    McapRecord record = new McapRecord(McapRecord.STATISTICS).u64(messages);
    record.u16(schemas.size()).u32(channelRecords.size()).u32(0);
    record.u32(metadataIndexes.size()).u32(chunkIndexes.size());
    return record.u64(first).u64(last).numbers(counts).bytes();
  }
}

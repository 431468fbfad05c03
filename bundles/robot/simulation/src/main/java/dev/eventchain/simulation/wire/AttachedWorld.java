package dev.eventchain.simulation.wire;

import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.dds.DdsReader;
import dev.eventchain.dds.DdsSample;
import dev.eventchain.dds.DdsWriter;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings.History;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.LongSupplier;

/** The world's writers and readers for nodes that run elsewhere. */
final class AttachedWorld implements AutoCloseable {

  /**
   * A received sample.
   *
   * @param reader the index of its reader
   * @param time wall time, in ns: the clocks of other machines may differ
   */
  record Arrival(int reader, long time, DdsSample sample) {}

  private static final String CLOCK = "/clock";
  private static final long SECOND = 1_000_000_000L;

  /** Depth of the history, the default of ROS 2: with KEEP_ALL, a stopped reader would block. */
  private static final int DEPTH = 10;

  private final WireGraph graph;
  private final List<DdsWriter> writers = new ArrayList<>();
  private final List<DdsReader> readers = new ArrayList<>();
  private final Queue<Arrival> arrivals = new ConcurrentLinkedQueue<>();
  private final MessageValue time;

  /**
   * Creates the writers and readers that the graph has for the world.
   *
   * @param wall the wall clock, in ns
   */
  AttachedWorld(
      DdsParticipant participant, WireGraph graph, MessageCatalog catalog, LongSupplier wall) {
    this.graph = graph;
    this.time = MessageValue.of(catalog.find("rosgraph_msgs/msg/Clock").orElseThrow());
    for (WireEnd end : graph.writersOf(WireEnd.WORLD)) {
      writers.add(
          participant.writer(
              end.topic(),
              type(catalog, end),
              end.qos().withHistory(History.KEEP_LAST).withDepth(DEPTH)));
    }
    for (WireEnd end : graph.readersOf(WireEnd.WORLD)) {
      readers.add(
          participant.reader(
              end.topic(),
              type(catalog, end),
              end.qos(),
              sample -> arrivals.add(new Arrival(end.index(), wall.getAsLong(), sample))));
    }
  }

  private static MessageType type(MessageCatalog catalog, WireEnd end) {
    return catalog.find(end.type()).orElseThrow();
  }

  /** Returns whether it has the writers and readers that another graph has for the world. */
  boolean suits(WireGraph other) {
    return graph.writersOf(WireEnd.WORLD).equals(other.writersOf(WireEnd.WORLD))
        && graph.readersOf(WireEnd.WORLD).equals(other.readersOf(WireEnd.WORLD));
  }

  /** Returns the writers and readers with too few matches, in words. */
  List<String> unconnected(WireGraph now) {
    List<String> missing = new ArrayList<>();
    for (WireEnd writer : now.writersOf(WireEnd.WORLD)) {
      if (writers.get(writer.index()).matched() < now.sinks(writer).size()) {
        missing.add("not all readers of " + writer.topic() + " are connected");
      }
    }
    for (WireEnd reader : now.readersOf(WireEnd.WORLD)) {
      if (readers.get(reader.index()).matched() < now.sources(reader).size()) {
        missing.add("not all writers of " + reader.topic() + " are connected");
      }
    }
    return missing;
  }

  /** Returns the number of matches of each writer and reader. */
  List<Integer> matches() {
    List<Integer> matches = new ArrayList<>();
    writers.forEach(writer -> matches.add(writer.matched()));
    readers.forEach(reader -> matches.add(reader.matched()));
    return matches;
  }

  /** Publishes a time, in ns, on the clock. */
  void show(long shown) {
    time.set("clock.sec", (int) (shown / SECOND));
    time.set("clock.nanosec", shown % SECOND);
    byte[] bytes = CdrCodec.encode(time);
    writers.stream()
        .filter(writer -> writer.topic().equals(CLOCK))
        .forEach(writer -> writer.write(bytes));
  }

  /**
   * Publishes a message, except those of the clock, which has a writer of its own.
   *
   * @param message for the topic with this index
   * @return the topic whose messages are no longer acknowledged; empty if all is well
   */
  String publish(int topic, ByteBuffer message) {
    DdsWriter writer = writers.get(topic);
    if (writer.topic().equals(CLOCK)) {
      return "";
    }
    byte[] bytes = new byte[message.remaining()];
    message.duplicate().get(bytes);
    return writer.write(bytes) ? "" : writer.topic();
  }

  /** Returns the samples received since the last call. */
  List<Arrival> arrivals() {
    List<Arrival> taken = new ArrayList<>();
    for (Arrival next = arrivals.poll(); next != null; next = arrivals.poll()) {
      taken.add(next);
    }
    return taken;
  }

  @Override
  public void close() {
    readers.forEach(DdsReader::close);
    writers.forEach(DdsWriter::close);
  }
}

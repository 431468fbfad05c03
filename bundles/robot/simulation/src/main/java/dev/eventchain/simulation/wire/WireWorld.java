package dev.eventchain.simulation.wire;

import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.dds.DdsReader;
import dev.eventchain.dds.DdsSample;
import dev.eventchain.dds.DdsWriter;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.simulation.host.NodeSession.Inbound;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/** The world's writers and readers in one scenario, and the clock. */
final class WireWorld implements AutoCloseable {

  /**
   * A received sample.
   *
   * @param reader the index of its reader
   */
  record Arrived(int reader, DdsSample sample) {}

  private static final String CLOCK = "/clock";
  private static final String CLOCK_TYPE = "rosgraph_msgs/msg/Clock";
  private static final long SECOND = 1_000_000_000L;

  /** A writer with the number and the source timestamps of its written samples. */
  private static final class Output {
    private final DdsWriter writer;
    private final int turns;
    private long written;
    private long last = -1;

    Output(DdsWriter writer, int turns) {
      this.writer = writer;
      this.turns = turns;
    }

    /** Returns a timestamp that is unique on the topic, where the world is the first writer. */
    long stamp(long now) {
      long earliest = Math.max(now, last + 1);
      last = (earliest + turns - 1) / turns * turns;
      return last;
    }
  }

  private final MessageValue time;
  private final List<Output> outputs = new ArrayList<>();
  private final List<DdsReader> readers = new ArrayList<>();
  private final long[] received;
  private final WireGraph graph;
  private final Runnable whenFull;
  private long shown = -1;
  private final Map<String, Map<Long, Long>> publications = new LinkedHashMap<>();

  /**
   * Creates the writers and readers that the graph has for the world.
   *
   * @param listener receives samples, from other threads
   * @param whenFull called repeatedly while readers do not accept written samples
   */
  WireWorld(
      DdsParticipant participant,
      WireGraph graph,
      MessageCatalog catalog,
      Consumer<Arrived> listener,
      Runnable whenFull) {
    this.graph = graph;
    this.whenFull = whenFull;
    this.time = MessageValue.of(type(catalog, CLOCK_TYPE));
    for (WireEnd end : graph.writersOf(WireEnd.WORLD)) {
      DdsWriter writer = participant.writer(end.topic(), type(catalog, end.type()), end.qos());
      outputs.add(new Output(writer, graph.owners(end.topic()).size()));
    }
    List<WireEnd> ends = graph.readersOf(WireEnd.WORLD);
    received = new long[ends.size()];
    for (WireEnd end : ends) {
      readers.add(
          participant.reader(
              end.topic(),
              type(catalog, end.type()),
              end.qos(),
              sample -> listener.accept(new Arrived(end.index(), sample))));
    }
  }

  private static MessageType type(MessageCatalog catalog, String name) {
    return catalog
        .find(name)
        .orElseThrow(() -> new IllegalArgumentException("no message type " + name));
  }

  /** Returns the GUID of an end of the graph. */
  String guid(WireEnd end) {
    if (end.owner() != WireEnd.WORLD) {
      return end.guid();
    }
    return graph.writers().contains(end)
        ? outputs.get(end.index()).writer.guid()
        : readers.get(end.index()).guid();
  }

  /**
   * Waits until all writers and readers have matched. Numbers would not do: ends of the previous
   * scenario are known for a while, and what is written to them is lost.
   *
   * @param clocks GUIDs of additional readers of the clock
   * @return the topics of writers and readers with missing matches, in words
   */
  List<String> connect(Set<String> clocks, Duration timeout) {
    long end = System.nanoTime() + timeout.toNanos();
    List<String> missing = new ArrayList<>();
    for (WireEnd writer : graph.writersOf(WireEnd.WORLD)) {
      Set<String> wanted = guids(graph.sinks(writer));
      wanted.addAll(writer.topic().equals(CLOCK) ? clocks : Set.of());
      if (!outputs.get(writer.index()).writer.waitForPeers(wanted, left(end))) {
        missing.add("its writer on " + writer.topic());
      }
    }
    for (WireEnd reader : graph.readersOf(WireEnd.WORLD)) {
      Set<String> wanted = guids(graph.sources(reader));
      if (!readers.get(reader.index()).waitForPeers(wanted, left(end))) {
        missing.add("its reader on " + reader.topic());
      }
    }
    return missing;
  }

  private Set<String> guids(List<WireEnd> ends) {
    return ends.stream().map(this::guid).collect(Collectors.toCollection(HashSet::new));
  }

  private static Duration left(long end) {
    return Duration.ofNanos(Math.max(1, end - System.nanoTime()));
  }

  /** Publishes a time, in ns, on the clock, unless it was published already. */
  void show(long now) {
    if (now > shown) {
      shown = now;
      time.set("clock.sec", (int) (now / SECOND));
      time.set("clock.nanosec", now % SECOND);
      byte[] bytes = CdrCodec.encode(time);
      outputs.stream()
          .filter(output -> output.writer.topic().equals(CLOCK))
          .forEach(output -> write(output, bytes, now));
    }
  }

  /** Publishes a message, except those of the clock, which has a writer of its own. */
  void publish(Inbound message, long now) {
    Output output = outputs.get(message.topic());
    if (!output.writer.topic().equals(CLOCK)) {
      byte[] bytes = new byte[message.message().remaining()];
      message.message().duplicate().get(bytes);
      write(output, bytes, now);
    }
  }

  private void write(Output output, byte[] bytes, long now) {
    long stamp = output.stamp(now);
    while (!output.writer.write(bytes, stamp)) {
      whenFull.run();
    }
    output.written++;
    publications
        .computeIfAbsent(output.writer.topic(), it -> new LinkedHashMap<>())
        .put(stamp, now);
  }

  /** Counts a sample. */
  void count(Arrived arrived) {
    received[arrived.reader()]++;
  }

  long written(int writer) {
    return outputs.get(writer).written;
  }

  long received(int reader) {
    return received[reader];
  }

  /** Returns the publication times in ns, by topic and source timestamp. */
  Map<String, Map<Long, Long>> publications() {
    return publications;
  }

  @Override
  public void close() {
    readers.forEach(DdsReader::close);
    outputs.forEach(it -> it.writer.close());
  }
}

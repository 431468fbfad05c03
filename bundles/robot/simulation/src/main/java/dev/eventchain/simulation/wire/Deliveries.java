package dev.eventchain.simulation.wire;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Tracks whether all written samples have been received by all matching readers. */
final class Deliveries {

  /** Number of samples that a writer has written, or a reader received, so far. */
  interface Counts {
    long of(WireEnd end);
  }

  private final WireGraph graph;
  private final Counts written;
  private final Counts received;
  private final Map<WireEnd, List<WireEnd>> sources = new HashMap<>();
  private final Map<WireEnd, Long> forgiven = new HashMap<>();
  private final Map<String, Long> lost = new TreeMap<>();

  Deliveries(WireGraph graph, Counts written, Counts received) {
    this.graph = graph;
    this.written = written;
    this.received = received;
    graph.readers().forEach(reader -> sources.put(reader, graph.sources(reader)));
  }

  private long underway(WireEnd reader) {
    long expected = sources.get(reader).stream().mapToLong(written::of).sum();
    return expected - received.of(reader) - forgiven.getOrDefault(reader, 0L);
  }

  /** Returns whether no sample is on the way. */
  boolean areComplete() {
    reconcile();
    return graph.readers().stream().allMatch(reader -> underway(reader) <= 0);
  }

  /** Returns the topics with samples on the way. */
  List<String> waitingTopics() {
    return waiting().stream().map(WireEnd::topic).distinct().sorted().toList();
  }

  private List<WireEnd> waiting() {
    List<WireEnd> waiting = new ArrayList<>();
    graph.readers().stream().filter(reader -> underway(reader) > 0).forEach(waiting::add);
    return waiting;
  }

  /** Counts best-effort samples on the way as lost. */
  void giveUp() {
    for (WireEnd reader : waiting()) {
      if (reader.isBestEffort()) {
        lost.merge(reader.topic(), underway(reader), Long::sum);
        forgiven.merge(reader, underway(reader), Long::sum);
      }
    }
  }

  /**
   * Reconciles abandoned samples that arrived late, so that they do not stand in for other ones.
   */
  private void reconcile() {
    forgiven.replaceAll((reader, count) -> count - Math.min(count, Math.max(0, -underway(reader))));
  }

  /** Returns the number of abandoned samples, by topic, whether late or never received. */
  Map<String, Long> lost() {
    return new TreeMap<>(lost);
  }
}

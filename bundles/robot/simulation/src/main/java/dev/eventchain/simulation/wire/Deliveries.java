package dev.eventchain.simulation.wire;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Whether everything that was written has been received, wherever it has to be. */
final class Deliveries {

  /** How many samples an end has written, or received, until now. */
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

  /** Whether nothing is underway. */
  boolean areComplete() {
    reconcile();
    return graph.readers().stream().allMatch(reader -> underway(reader) <= 0);
  }

  /** The topics on which something is underway. */
  List<String> waitingTopics() {
    return waiting().stream().map(WireEnd::topic).distinct().sorted().toList();
  }

  private List<WireEnd> waiting() {
    List<WireEnd> waiting = new ArrayList<>();
    graph.readers().stream().filter(reader -> underway(reader) > 0).forEach(waiting::add);
    return waiting;
  }

  /** Takes what is underway by best effort for lost. */
  void giveUp() {
    for (WireEnd reader : waiting()) {
      if (reader.isBestEffort()) {
        lost.merge(reader.topic(), underway(reader), Long::sum);
        forgiven.merge(reader, underway(reader), Long::sum);
      }
    }
  }

  /** What comes after it was abandoned is waited for no more, and takes the place of no other. */
  private void reconcile() {
    forgiven.replaceAll((reader, count) -> count - Math.min(count, Math.max(0, -underway(reader))));
  }

  /** How many samples were abandoned, by topic, whether they came too late or not at all. */
  Map<String, Long> lost() {
    return new TreeMap<>(lost);
  }
}

package dev.eventchain.simulation.measure;

import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.host.RunLog.Activation;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Order of nodes from the first ones along the samples that they read and wrote, independent of
 * their order in the model. In a loop, nodes fewer steps away from the first ones come first;
 * connections back are feedback.
 */
final class ActivationOrder {

  private final Map<String, Set<String>> readers = new LinkedHashMap<>();
  private final Map<String, Integer> distances = new LinkedHashMap<>();
  private final Map<String, Set<String>> reachable = new HashMap<>();
  private final Map<String, Integer> positions = new HashMap<>();

  private ActivationOrder(RunLog log, Set<String> first) {
    Map<String, Set<String>> readersOf = new HashMap<>();
    log.nodes()
        .forEach(
            (node, activations) ->
                activations.stream()
                    .flatMap(each -> each.reads().stream())
                    .forEach(
                        read ->
                            readersOf
                                .computeIfAbsent(read.topic(), none -> new LinkedHashSet<>())
                                .add(node)));
    log.nodes().forEach((node, activations) -> readers.put(node, next(activations, readersOf)));
    distances.putAll(distancesFrom(first));
  }

  private static Set<String> next(
      List<Activation> activations, Map<String, Set<String>> readersOf) {
    Set<String> next = new LinkedHashSet<>();
    activations.stream()
        .flatMap(each -> each.writes().stream())
        .forEach(written -> next.addAll(readersOf.getOrDefault(written.topic(), Set.of())));
    return next;
  }

  /**
   * Returns the positions of the first nodes and all nodes behind them. Samples written at one
   * position are read at higher ones, except for feedback.
   */
  static Map<String, Integer> of(RunLog log, Set<String> first) {
    ActivationOrder order = new ActivationOrder(log, first);
    order.distances.keySet().forEach(order::position);
    return order.positions;
  }

  /** Returns the length of the longest path to a node without feedback. */
  private int position(String node) {
    Integer known = positions.get(node);
    if (known != null) {
      return known;
    }
    int position = 0;
    for (String before : distances.keySet()) {
      if (readers.get(before).contains(node) && isForward(before, node)) {
        position = Math.max(position, position(before) + 1);
      }
    }
    positions.put(node, position);
    return position;
  }

  private boolean isForward(String writer, String reader) {
    boolean loop = reachable.computeIfAbsent(reader, this::reachableFrom).contains(writer);
    return !loop || distances.get(writer) < distances.get(reader);
  }

  private Set<String> reachableFrom(String node) {
    return new HashSet<>(distancesFrom(Set.of(node)).keySet());
  }

  /** Returns the distance of each node, in steps. */
  private Map<String, Integer> distancesFrom(Set<String> start) {
    Map<String, Integer> found = new LinkedHashMap<>();
    readers.keySet().stream().filter(start::contains).forEach(node -> found.put(node, 0));
    Deque<String> open = new ArrayDeque<>(found.keySet());
    while (!open.isEmpty()) {
      String node = open.remove();
      for (String next : readers.get(node)) {
        if (found.putIfAbsent(next, found.get(node) + 1) == null) {
          open.add(next);
        }
      }
    }
    return found;
  }
}

package dev.eventchain.contracts.timing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Tasks with forks and joins. A latency between two tasks is that of the slowest path: an output
 * counts as based on the oldest of what comes together in it. Connections back towards the first
 * task are feedback and not followed.
 */
public final class TaskGraph {

  /** The most paths between two tasks that are looked at. */
  private static final int MOST_PATHS = 1_000;

  private final Map<String, Task> tasks = new LinkedHashMap<>();
  private final Map<String, List<String>> readers = new HashMap<>();

  /** Adds a task, or replaces the one of the same name. */
  public void add(Task task) {
    tasks.put(task.name(), task);
  }

  /** Lets a task read the output of another one; both have to be there. */
  public void connect(String writer, String reader) {
    if (!tasks.containsKey(writer) || !tasks.containsKey(reader)) {
      throw new IllegalArgumentException(writer + " -> " + reader);
    }
    List<String> known = readers.computeIfAbsent(writer, none -> new ArrayList<>());
    if (!known.contains(reader)) {
      known.add(reader);
    }
  }

  /**
   * Returns the latencies along all paths between two tasks; empty if there are more than 1,000. A
   * task is connected with itself.
   */
  public Optional<List<PathLatency>> between(LatencyType type, String first, String last) {
    Map<String, List<String>> forward = forward(first);
    Set<String> reaching = reaching(forward, last);
    forward.values().forEach(each -> each.retainAll(reaching));
    List<List<Task>> paths = new ArrayList<>();
    return addPaths(forward, first, last, new ArrayDeque<>(), paths)
        ? Optional.of(paths.stream().map(path -> PathLatency.of(type, path)).toList())
        : Optional.empty();
  }

  /** Adds the paths from a task on; returns false if there are too many. */
  private boolean addPaths(
      Map<String, List<String>> forward,
      String task,
      String last,
      Deque<Task> path,
      List<List<Task>> paths) {
    path.addLast(tasks.get(task));
    boolean few = true;
    if (task.equals(last)) {
      paths.add(List.copyOf(path));
      few = paths.size() <= MOST_PATHS;
    } else {
      for (String next : forward.getOrDefault(task, List.of())) {
        few = few && addPaths(forward, next, last, path, paths);
      }
    }
    path.removeLast();
    return few;
  }

  /**
   * Returns the readers of each task that the first one reaches, without feedback: within a loop,
   * only those that are more steps away from the first one.
   */
  private Map<String, List<String>> forward(String first) {
    Map<String, Integer> distances = distances(first, first);
    Map<String, Set<String>> behind = new HashMap<>();
    Map<String, List<String>> forward = new HashMap<>();
    for (String writer : distances.keySet()) {
      List<String> next = new ArrayList<>(readersOf(writer, first));
      next.removeIf(
          reader ->
              distances.get(writer) >= distances.get(reader)
                  && behind
                      .computeIfAbsent(reader, it -> distances(it, first).keySet())
                      .contains(writer));
      forward.put(writer, next);
    }
    return forward;
  }

  /** Returns the readers of a task other than the start of the paths. */
  private List<String> readersOf(String task, String start) {
    List<String> all = readers.getOrDefault(task, List.of());
    return all.stream().filter(reader -> !reader.equals(start)).toList();
  }

  /** Returns the number of steps from a task to each that its outputs reach. */
  private Map<String, Integer> distances(String from, String start) {
    Map<String, Integer> distances = new HashMap<>(Map.of(from, 0));
    Deque<String> open = new ArrayDeque<>(List.of(from));
    while (!open.isEmpty()) {
      String task = open.remove();
      for (String next : readersOf(task, start)) {
        if (distances.putIfAbsent(next, distances.get(task) + 1) == null) {
          open.add(next);
        }
      }
    }
    return distances;
  }

  /** Returns the tasks from which the last one is reached, and itself. */
  private static Set<String> reaching(Map<String, List<String>> forward, String last) {
    Map<String, List<String>> writers = new HashMap<>();
    forward.forEach(
        (writer, all) ->
            all.forEach(
                reader -> writers.computeIfAbsent(reader, none -> new ArrayList<>()).add(writer)));
    Set<String> found = new HashSet<>(Set.of(last));
    Deque<String> open = new ArrayDeque<>(found);
    while (!open.isEmpty()) {
      for (String writer : writers.getOrDefault(open.remove(), List.of())) {
        if (found.add(writer)) {
          open.add(writer);
        }
      }
    }
    return found;
  }
}

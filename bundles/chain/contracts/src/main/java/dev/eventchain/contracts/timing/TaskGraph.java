package dev.eventchain.contracts.timing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Tasks with forks and joins. A latency between two tasks is that of the slowest path: an output
 * counts as based on the oldest of what comes together in it. Connections back towards the first
 * task are feedback and not followed.
 */
public final class TaskGraph {

  /** The most paths between two tasks that are looked at, and the most tasks on them. */
  private static final int MOST = 1_000;

  private static final int NOT_REACHED = -1;

  private final List<Task> tasks = new ArrayList<>();
  private final Map<String, Integer> numbers = new HashMap<>();
  private final List<List<Integer>> readers = new ArrayList<>();
  private final List<List<Integer>> writers = new ArrayList<>();

  /**
   * Adds a task.
   *
   * @throws IllegalArgumentException if there is one of that name
   */
  public void add(Task task) {
    if (numbers.putIfAbsent(task.name(), tasks.size()) != null) {
      throw new IllegalArgumentException("two tasks '" + task.name() + "'");
    }
    tasks.add(task);
    readers.add(new ArrayList<>());
    writers.add(new ArrayList<>());
  }

  /** Lets a task read the output of another one; both have to be there. */
  public void connect(String writer, String reader) {
    int from = number(writer);
    int to = number(reader);
    if (!readers.get(from).contains(to)) {
      readers.get(from).add(to);
      writers.get(to).add(from);
    }
  }

  private int number(String name) {
    Integer number = numbers.get(name);
    if (number == null) {
      throw new IllegalArgumentException("no task '" + name + "'");
    }
    return number;
  }

  /**
   * Returns the latencies along all paths between two tasks; empty if there are more than 1,000, or
   * more than 1,000 tasks on them. A task is connected with itself.
   */
  public Optional<List<PathLatency>> between(LatencyType type, String first, String last) {
    int start = number(first);
    int end = number(last);
    int[] distances = distances(readers, start, start);
    BitSet between = reached(distances);
    between.and(reached(distances(writers, end, NOT_REACHED)));
    if (between.cardinality() > MOST) {
      return Optional.empty();
    }
    Paths paths = new Paths(end, forward(start, distances, between));
    return paths.addFrom(start, new ArrayDeque<>())
        ? Optional.of(paths.found.stream().map(path -> PathLatency.of(type, path)).toList())
        : Optional.empty();
  }

  /**
   * Returns the number of steps to each task that is reached.
   *
   * @param excluded a task to which no step leads
   */
  private int[] distances(List<List<Integer>> next, int from, int excluded) {
    int[] distances = new int[tasks.size()];
    Arrays.fill(distances, NOT_REACHED);
    distances[from] = 0;
    Deque<Integer> open = new ArrayDeque<>(List.of(from));
    while (!open.isEmpty()) {
      int task = open.remove();
      for (int each : next.get(task)) {
        if (distances[each] == NOT_REACHED && each != excluded) {
          distances[each] = distances[task] + 1;
          open.add(each);
        }
      }
    }
    return distances;
  }

  private static BitSet reached(int[] distances) {
    BitSet reached = new BitSet(distances.length);
    for (int i = 0; i < distances.length; i++) {
      reached.set(i, distances[i] != NOT_REACHED);
    }
    return reached;
  }

  /**
   * Returns the readers of each task on the way without feedback: within a loop, only those that
   * are more steps away from the first task.
   */
  private Map<Integer, List<Integer>> forward(int start, int[] distances, BitSet between) {
    Map<Integer, BitSet> behind = new HashMap<>();
    Map<Integer, List<Integer>> forward = new HashMap<>();
    between.stream()
        .forEach(
            writer -> {
              List<Integer> next = new ArrayList<>(readers.get(writer));
              next.removeIf(reader -> reader == start || !between.get(reader));
              next.removeIf(
                  reader ->
                      distances[writer] >= distances[reader]
                          && behind
                              .computeIfAbsent(reader, it -> reached(distances(readers, it, start)))
                              .get(writer));
              forward.put(writer, next);
            });
    return forward;
  }

  /** All paths to a task. */
  private final class Paths {

    private final int end;
    private final Map<Integer, List<Integer>> forward;
    private final List<List<Task>> found = new ArrayList<>();

    /** Tasks from which no path leads to the end. */
    private final BitSet dead = new BitSet();

    Paths(int end, Map<Integer, List<Integer>> forward) {
      this.end = end;
      this.forward = forward;
    }

    /** Adds the paths from a task on; returns false if there are too many. */
    private boolean addFrom(int task, Deque<Task> path) {
      if (dead.get(task)) {
        return true;
      }
      int before = found.size();
      boolean few = true;
      path.addLast(tasks.get(task));
      if (task == end) {
        found.add(List.copyOf(path));
        few = found.size() <= MOST;
      } else {
        for (int next : forward.getOrDefault(task, List.of())) {
          few = few && addFrom(next, path);
        }
      }
      path.removeLast();
      dead.set(task, few && found.size() == before);
      return few;
    }
  }
}

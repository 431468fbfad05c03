package dev.eventchain.contracts.timing;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Timers of one clock, each released when the output of the task before it has arrived: what a
 * bound would be if the phases were set so. A task on several paths has one phase, that of the
 * slowest of them.
 *
 * @param bound that of the path which is slowest with these phases
 * @param phases the first releases, by task, in ns; those of the slowest path first
 */
public record AlignedTimers(Bound bound, Map<String, Long> phases) {

  /**
   * Returns them for paths of timers and what their messages activate, all with bounds; empty if
   * other tasks are on them.
   */
  public static Optional<AlignedTimers> of(LatencyType type, List<PathLatency> paths) {
    boolean timers =
        paths.stream()
            .flatMap(path -> Segment.of(path.path()).stream())
            .allMatch(segment -> segment.head().trigger() == Trigger.PERIODIC);
    if (!timers) {
      return Optional.empty();
    }
    Map<String, Long> phases = new LinkedHashMap<>();
    paths.stream()
        .sorted(
            Comparator.comparingLong((PathLatency path) -> path.bound().orElseThrow().time())
                .reversed())
        .forEach(path -> addPhases(path.path(), phases));
    return paths.stream()
        .map(path -> aligned(path.path(), phases))
        .map(path -> PathLatency.of(type, path).bound().orElseThrow())
        .max(Comparator.comparingLong(Bound::time))
        .map(bound -> new AlignedTimers(bound, phases));
  }

  /** Adds the phases of the tasks on a path that have none yet. */
  private static void addPhases(List<Task> path, Map<String, Long> phases) {
    long end = 0;
    for (Task task : path) {
      if (task.trigger() == Trigger.PERIODIC) {
        phases.putIfAbsent(task.name(), end % task.period().orElseThrow());
        end = phases.get(task.name());
      }
      end += task.response().orElseThrow();
    }
  }

  private static List<Task> aligned(List<Task> path, Map<String, Long> phases) {
    return path.stream()
        .map(
            task ->
                task.trigger() == Trigger.PERIODIC ? task.withPhase(phases.get(task.name())) : task)
        .toList();
  }
}

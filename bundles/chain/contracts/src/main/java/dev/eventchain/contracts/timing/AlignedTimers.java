package dev.eventchain.contracts.timing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Timers of one clock, each released when the task before it has ended: what a bound would be if
 * the phases of a path were set so.
 *
 * @param phases the first releases, by task, in ns
 */
public record AlignedTimers(Bound bound, Map<String, Long> phases) {

  /** Returns them for a path of timers with bounds; empty if other tasks are on it. */
  public static Optional<AlignedTimers> of(LatencyType type, List<Task> path) {
    List<Task> aligned = new ArrayList<>();
    Map<String, Long> phases = new LinkedHashMap<>();
    long end = 0;
    for (Task task : path) {
      if (task.trigger() != Trigger.PERIODIC) {
        return Optional.empty();
      }
      long phase = end % task.period().orElseThrow();
      phases.put(task.name(), phase);
      aligned.add(task.withPhase(phase));
      end = phase + task.response().orElseThrow();
    }
    return ReleasedBound.kloda()
        .of(type, Segment.of(aligned))
        .map(bound -> new AlignedTimers(bound, phases));
  }
}

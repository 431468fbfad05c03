package dev.eventchain.contracts.timing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;

/**
 * Effect of the periods of tasks on a latency, each on its own: the others keep theirs. Counted
 * with the bounds for any phases, which never fall when a period grows.
 */
public final class Sensitivity {

  /**
   * Effect of the period of a task.
   *
   * @param saved what the bound falls by if the task is executed twice as often, or as often as its
   *     response time allows if that is less, in ns
   * @param largest the largest period with which the bound holds, in ns; empty if none does
   */
  public record Effect(long period, long saved, OptionalLong largest) {}

  private final LatencyType type;
  private final List<List<Task>> paths;
  private final long maximum;

  private Sensitivity(LatencyType type, List<List<Task>> paths, long maximum) {
    this.type = type;
    this.paths = paths;
    this.maximum = maximum;
  }

  /**
   * Returns the effects of the periods that take part in a latency, by the names of the tasks.
   *
   * @param paths with bounds
   * @param maximum what the bound must not pass, in ns
   */
  public static Map<String, Effect> of(LatencyType type, List<PathLatency> paths, long maximum) {
    List<List<Task>> tasks = paths.stream().map(PathLatency::path).toList();
    Sensitivity sensitivity = new Sensitivity(type, tasks, maximum);
    Map<String, Effect> effects = new LinkedHashMap<>();
    long bound = sensitivity.bound(tasks);
    for (List<Task> path : tasks) {
      for (Task task : path) {
        if (isAlone(task) && sensitivity.matters(task, bound)) {
          effects.computeIfAbsent(task.name(), none -> sensitivity.effect(task, bound));
        }
      }
    }
    return effects;
  }

  /**
   * Returns whether a timer's period has no effect on the response times of other tasks, as one on
   * a shared processor has.
   */
  private static boolean isAlone(Task task) {
    return task.trigger() == Trigger.PERIODIC && task.placement().processor().isEmpty();
  }

  /**
   * Returns whether the bound depends on a period: that of a task at the end of a data age does
   * not.
   */
  private boolean matters(Task task, long bound) {
    return with(task, bound + task.period().orElseThrow()) > bound;
  }

  private Effect effect(Task task, long bound) {
    long period = task.period().orElseThrow();
    long shortest = Math.max(1, task.response().orElseThrow());
    long halved = with(task, Math.min(period, Math.max(period / 2, shortest)));
    return new Effect(period, bound - halved, largest(task, shortest));
  }

  private OptionalLong largest(Task task, long shortest) {
    long holds = shortest;
    if (with(task, holds) > maximum) {
      return OptionalLong.empty();
    }
    long fails = Math.max(maximum, shortest) + 1;
    while (fails - holds > 1) {
      long middle = (holds + fails) / 2;
      if (with(task, middle) > maximum) {
        fails = middle;
      } else {
        holds = middle;
      }
    }
    return OptionalLong.of(holds);
  }

  /** Returns the bound if a task has another period. */
  private long with(Task task, long period) {
    List<List<Task>> changed = new ArrayList<>();
    for (List<Task> path : paths) {
      changed.add(
          path.stream()
              .map(each -> each.name().equals(task.name()) ? each.withPeriod(period) : each)
              .toList());
    }
    return bound(changed);
  }

  private long bound(List<List<Task>> all) {
    return all.stream()
        .mapToLong(
            path -> {
              List<Segment> segments = Segment.of(path);
              long davare = SummedBound.davare().of(type, segments).orElseThrow().time();
              return Math.min(davare, SummedBound.duerr().of(type, segments).orElseThrow().time());
            })
        .max()
        .orElse(0);
  }
}

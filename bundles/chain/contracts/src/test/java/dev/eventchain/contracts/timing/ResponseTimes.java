package dev.eventchain.contracts.timing;

import java.util.List;
import java.util.OptionalLong;

/**
 * Worst-case response times of periodic tasks on one processor, each task with a priority of its
 * own. A task that may not end within its period has none.
 */
final class ResponseTimes {

  /**
   * What a task asks of its processor.
   *
   * @param period in ns
   * @param execution the worst-case execution time, in ns
   * @param priority larger numbers go first
   */
  record Demand(long period, long execution, int priority) {}

  private final List<Demand> all;

  private ResponseTimes(List<Demand> all) {
    this.all = List.copyOf(all);
  }

  /** Returns the response times of the tasks of one processor. */
  static ResponseTimes of(List<Demand> all) {
    return new ResponseTimes(all);
  }

  /**
   * Returns the response time of a task that others of higher priority interrupt, by the analysis
   * of M. Joseph and P. Pandya, 1986.
   */
  OptionalLong preemptive(Demand task) {
    long response = task.execution();
    while (response <= task.period()) {
      long next = task.execution();
      for (Demand other : all) {
        if (other.priority() > task.priority()) {
          next += -Math.floorDiv(-response, other.period()) * other.execution();
        }
      }
      if (next == response) {
        return OptionalLong.of(response);
      }
      response = next;
    }
    return OptionalLong.empty();
  }
}

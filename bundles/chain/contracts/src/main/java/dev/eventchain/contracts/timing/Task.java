package dev.eventchain.contracts.timing;

import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * Task of a cause-effect chain: a component, or the way of a message. All times are in ns.
 *
 * @param name unique within a graph
 * @param trigger what activates it
 * @param period the period of its timer, or the longest separation of the events or messages that
 *     activate it; empty if unknown
 * @param phase the first release; empty if it may be any
 * @param response the worst-case response time, or the interval of a logical execution time; empty
 *     if unknown
 * @param shortest the shortest response time
 * @param placement where it executes, if that is known
 */
public record Task(
    String name,
    Trigger trigger,
    OptionalLong period,
    OptionalLong phase,
    OptionalLong response,
    long shortest,
    Placement placement) {

  /**
   * Processor and priority of a task.
   *
   * @param processor empty if unknown: then it may be any other than those of the other tasks
   * @param priority larger numbers go first; empty if unknown
   */
  public record Placement(String processor, OptionalInt priority) {

    /** A processor that is not known. */
    public static final Placement UNKNOWN = new Placement("", OptionalInt.empty());

    /**
     * Returns whether jobs of this placement have ended before a job of the other one starts, if
     * they were released before it or at the same time.
     */
    boolean goesBefore(Placement other) {
      return !processor.isEmpty()
          && processor.equals(other.processor)
          && priority.isPresent()
          && other.priority.isPresent()
          && priority.getAsInt() > other.priority.getAsInt();
    }
  }

  /** Refuses times that are impossible. */
  public Task {
    if (period.isPresent() && period.getAsLong() <= 0) {
      throw new IllegalArgumentException("the period of '" + name + "' is not above 0");
    }
    if (shortest < 0 || (response.isPresent() && response.getAsLong() < shortest)) {
      throw new IllegalArgumentException("the response times of '" + name + "' are no interval");
    }
    if (phase.isPresent() && phase.getAsLong() < 0) {
      throw new IllegalArgumentException("the phase of '" + name + "' is below 0");
    }
  }

  /** Returns a periodic task of any phase on a processor that is not known. */
  public static Task periodic(String name, long period, long response) {
    return new Task(
        name,
        Trigger.PERIODIC,
        OptionalLong.of(period),
        OptionalLong.empty(),
        OptionalLong.of(response),
        0,
        Placement.UNKNOWN);
  }

  /** Returns a task of logical execution times that take its whole period. */
  public static Task logical(String name, long period, long phase) {
    return new Task(
        name,
        Trigger.LOGICAL,
        OptionalLong.of(period),
        OptionalLong.of(phase),
        OptionalLong.of(period),
        period,
        Placement.UNKNOWN);
  }

  /** Returns a task that each message of the task before it activates. */
  public static Task onMessage(String name, long response) {
    return onMessage(name, OptionalLong.of(response));
  }

  /** As {@link #onMessage(String, long)}; without a response time if it is not known. */
  public static Task onMessage(String name, OptionalLong response) {
    return new Task(
        name,
        Trigger.MESSAGE,
        OptionalLong.empty(),
        OptionalLong.empty(),
        response,
        0,
        Placement.UNKNOWN);
  }

  /** Returns this task with a known first release. */
  public Task withPhase(long known) {
    return new Task(name, trigger, period, OptionalLong.of(known), response, shortest, placement);
  }

  /** Returns this task with another period. */
  public Task withPeriod(long other) {
    return new Task(name, trigger, OptionalLong.of(other), phase, response, shortest, placement);
  }

  /** Returns this task on a processor, with a priority; larger numbers go first. */
  public Task on(String processor, int priority) {
    Placement place = new Placement(processor, OptionalInt.of(priority));
    return new Task(name, trigger, period, phase, response, shortest, place);
  }
}

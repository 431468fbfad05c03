package dev.eventchain.contracts.timing;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * Upper bounds on the response times of periodic tasks on one processor, which executes one task at
 * a time and never idles while one waits.
 *
 * <p>Where all tasks have priorities, a task waits for those of its own or a higher one, which
 * interrupt it: the recurrence of M. Joseph and P. Pandya, 1986. With a priority of its own for
 * each task it is exact, since no phases are known and all tasks may be released together.
 *
 * <p>Otherwise any task may go first, also without being interrupted, as in a single-threaded
 * executor of ROS 2, whose callbacks go by its polling points (D. Casini et al., ECRTS 2019). Then
 * a job ends within the longest time that the processor is busy without a break, which begins when
 * all tasks are released together (C. Liu and J. Layland, 1973). If that fits into the task's
 * period, one job of the task is in it, so that the same recurrence over all tasks gives its
 * length.
 */
public final class ResponseTimes {

  /** The most steps for the tasks of one processor; where they do not suffice, nothing is known. */
  private static final long MOST_STEPS = 20_000_000;

  private final List<Demand> all;
  private final boolean ordered;
  private long steps;

  private ResponseTimes(List<Demand> all) {
    this.all = all;
    ordered = ordered(all);
  }

  /**
   * Demand of a task on its processor. Empty is what is not known.
   *
   * @param period above 0, in ns; the shortest one, if it is not a whole number
   * @param execution the worst-case execution time, above 0, in ns
   * @param priority larger numbers go first
   */
  public record Demand(OptionalLong period, OptionalLong execution, OptionalInt priority) {

    /** Refuses times that are impossible. */
    public Demand {
      if (period.orElse(1) <= 0 || execution.orElse(1) <= 0) {
        throw new IllegalArgumentException("times of a task are not above 0");
      }
    }

    private boolean isKnown() {
      return period.isPresent() && execution.isPresent();
    }
  }

  /** Kind of a result. */
  public enum Outcome {
    /** Each job ends within the bound, which is not longer than the period. */
    BOUNDED,
    /**
     * With some phases, or some order where there are no priorities, a job ends after the period.
     */
    LATE,
    /** A number of the task, or of one that may go first, is not known. */
    UNKNOWN
  }

  /**
   * Response time of a task.
   *
   * @param bound in ns; empty unless there is one
   */
  public record Response(Outcome outcome, OptionalLong bound) {

    private static final Response LATE = new Response(Outcome.LATE, OptionalLong.empty());
    private static final Response UNKNOWN = new Response(Outcome.UNKNOWN, OptionalLong.empty());
  }

  /** Returns whether priorities say which task goes first: each task has one. */
  public static boolean ordered(List<Demand> all) {
    return all.stream().allMatch(task -> task.priority().isPresent());
  }

  /** Returns the response times of the tasks of one processor, in their order. */
  public static List<Response> of(List<Demand> all) {
    ResponseTimes times = new ResponseTimes(List.copyOf(all));
    List<Response> responses = new ArrayList<>();
    for (int task = 0; task < all.size(); task++) {
      responses.add(times.response(task));
    }
    return responses;
  }

  private Response response(int task) {
    Demand own = all.get(task);
    List<Demand> first = first(task);
    if (!own.isKnown() || !first.stream().allMatch(Demand::isKnown)) {
      return Response.UNKNOWN;
    }
    long period = own.period().getAsLong();
    long response = own.execution().getAsLong();
    while (response <= period) {
      steps += first.size() + 1;
      if (steps > MOST_STEPS) {
        return Response.UNKNOWN;
      }
      long next = next(own, first, response);
      if (next == response) {
        return new Response(Outcome.BOUNDED, OptionalLong.of(response));
      }
      response = next;
    }
    return Response.LATE;
  }

  /** Returns the tasks that may go before another one. */
  private List<Demand> first(int task) {
    List<Demand> first = new ArrayList<>();
    for (int other = 0; other < all.size(); other++) {
      if (other != task && mayGoBefore(all.get(other), all.get(task))) {
        first.add(all.get(other));
      }
    }
    return first;
  }

  private boolean mayGoBefore(Demand other, Demand task) {
    return !ordered || other.priority().getAsInt() >= task.priority().getAsInt();
  }

  /** Returns the work that is released within a time, and a longer one than the period if it is. */
  private static long next(Demand own, List<Demand> first, long time) {
    long period = own.period().getAsLong();
    long work = own.execution().getAsLong();
    for (Demand other : first) {
      long execution = other.execution().getAsLong();
      long jobs = -Math.floorDiv(-time, other.period().getAsLong());
      if (jobs > (period - work) / execution) {
        return period + 1;
      }
      work += jobs * execution;
    }
    return work;
  }
}

package dev.eventchain.contracts.timing;

import java.util.ArrayList;
import java.util.List;

/**
 * A task that samples its input, and the tasks that its messages activate one after the other. They
 * take part in bounds like one task whose response times are the sum of theirs.
 *
 * @param head the task that samples; a task that messages activate only at the start of a path
 */
record Segment(Task head, List<Task> followers) {

  /** Returns the segments of a path. */
  static List<Segment> of(List<Task> path) {
    List<Segment> segments = new ArrayList<>();
    for (Task task : path) {
      if (task.trigger() == Trigger.MESSAGE && !segments.isEmpty()) {
        segments.get(segments.size() - 1).followers().add(task);
      } else {
        segments.add(new Segment(task, new ArrayList<>()));
      }
    }
    return segments;
  }

  /** Returns whether an event from outside starts it at once, as the first one of a path. */
  boolean startsAtOnce() {
    return !isReleasedByClock();
  }

  /** Returns whether each message may start it at once, as far as is known. */
  boolean mayFollowAtOnce() {
    return !isReleasedByClock() && head.period().isEmpty();
  }

  boolean isReleasedByClock() {
    return head.trigger() == Trigger.PERIODIC || head.trigger() == Trigger.LOGICAL;
  }

  /** Returns the longest separation of releases. */
  long period() {
    return head.period().orElseThrow();
  }

  /** Returns the first release if all of them are known. */
  long phase() {
    return Math.floorMod(head.phase().orElseThrow(), period());
  }

  /** Returns the longest time from the event that it just misses to its release, as a first one. */
  long firstWaiting() {
    return startsAtOnce() ? 0 : period();
  }

  long response() {
    return head.response().orElseThrow()
        + followers.stream().mapToLong(task -> task.response().orElseThrow()).sum();
  }

  /**
   * Returns how much of the response time of this segment passes before a release of the next one
   * that reads its output: none of it if its jobs always go first.
   */
  long delayBefore(Segment next) {
    boolean readsAtStart =
        head.trigger() != Trigger.LOGICAL && next.head.trigger() != Trigger.LOGICAL;
    boolean goesBefore = head.placement().goesBefore(next.head.placement());
    return followers.isEmpty() && readsAtStart && goesBefore ? 0 : response();
  }

  /**
   * Returns the parts of its tasks in a latency.
   *
   * @param waiting that of the segment
   * @param counted the part of its response time that counts, from the first task on
   */
  List<Bound.Share> shares(long waiting, long counted) {
    List<Bound.Share> shares = new ArrayList<>();
    long before = waiting;
    long left = counted;
    List<Task> tasks = new ArrayList<>(List.of(head));
    tasks.addAll(followers);
    for (Task task : tasks) {
      long part = Math.min(left, task.response().orElseThrow());
      shares.add(new Bound.Share(task.name(), before, part));
      left -= part;
      before = 0;
    }
    return shares;
  }
}

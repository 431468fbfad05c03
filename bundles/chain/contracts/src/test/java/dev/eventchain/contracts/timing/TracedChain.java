package dev.eventchain.contracts.timing;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/**
 * Brute force: a schedule of jobs in steps of one tick, and the end-to-end times that occurred in
 * it.
 */
final class TracedChain {

  /** A job; a job that has not ended by the end of the schedule is left out. */
  private static final class Job {
    private final int task;
    private final long release;
    private long left;
    private long read = -1;
    private long write = -1;

    /** The job of the first task that it is based on; -1 if there is none. */
    private int source = -1;

    Job(int task, long release, long left) {
      this.task = task;
      this.release = release;
      this.left = left;
    }
  }

  private final List<List<Job>> jobs = new ArrayList<>();
  private final long settled;

  /**
   * Runs a chain of tasks.
   *
   * @param executions the worst-case execution times; ignored for logical execution times
   * @param ticks how long
   * @param random draws execution times, of which two thirds are the worst case
   */
  TracedChain(List<Task> chain, List<Long> executions, long ticks, Random random) {
    settled = chain.stream().mapToLong(it -> it.phase().orElse(0) + 2 * period(it)).sum();
    for (int i = 0; i < chain.size(); i++) {
      jobs.add(new ArrayList<>());
      if (chain.get(i).trigger() != Trigger.MESSAGE) {
        release(chain.get(i), i, executions.get(i), ticks, random);
      }
    }
    execute(chain, ticks);
    for (int i = 1; i < chain.size(); i++) {
      if (chain.get(i).trigger() == Trigger.MESSAGE) {
        answerMessages(i, executions.get(i), random);
      }
    }
    jobs.forEach(each -> each.removeIf(job -> job.write < 0 || job.write > ticks));
    trace();
  }

  private static long period(Task task) {
    return task.period().orElse(0);
  }

  private static long execution(long worst, Random random) {
    long shorter = 1 + (long) (random.nextDouble() * worst);
    return random.nextInt(3) > 0 ? worst : Math.min(worst, shorter);
  }

  private void release(Task task, int index, long worst, long ticks, Random random) {
    for (long at = task.phase().orElse(0); at < ticks; at += period(task)) {
      Job job = new Job(index, at, execution(worst, random));
      if (task.trigger() == Trigger.LOGICAL) {
        job.read = at;
        job.write = at + period(task);
      }
      jobs.get(index).add(job);
    }
  }

  /** Adds a job for each that ended of the task before; answers keep the order of messages. */
  private void answerMessages(int index, long worst, Random random) {
    long before = 0;
    for (Job writer : jobs.get(index - 1)) {
      if (writer.write >= 0) {
        Job job = new Job(index, writer.write, 0);
        job.read = writer.write;
        job.write = Math.max(before, job.read + execution(worst, random));
        before = job.write;
        jobs.get(index).add(job);
      }
    }
  }

  /** Executes on each processor the released job of the highest priority, tick by tick. */
  private void execute(List<Task> chain, long ticks) {
    List<String> processors =
        chain.stream()
            .filter(task -> task.trigger() == Trigger.PERIODIC)
            .map(task -> task.placement().processor())
            .distinct()
            .toList();
    for (String processor : processors) {
      List<Job> pending =
          new ArrayList<>(
              jobs.stream()
                  .flatMap(List::stream)
                  .filter(job -> chain.get(job.task).placement().processor().equals(processor))
                  .sorted(
                      Comparator.comparingInt(
                              (Job job) ->
                                  -chain.get(job.task).placement().priority().orElseThrow())
                          .thenComparingLong(job -> job.release))
                  .toList());
      for (long now = 0; now < ticks; now++) {
        step(pending, now);
      }
    }
  }

  private static void step(List<Job> pending, long now) {
    Optional<Job> next = pending.stream().filter(job -> job.release <= now).findFirst();
    if (next.isPresent()) {
      Job job = next.get();
      job.read = job.read < 0 ? now : job.read;
      job.left--;
      if (job.left == 0) {
        job.write = now + 1;
        pending.remove(job);
      }
    }
  }

  private void trace() {
    List<Job> first = jobs.get(0);
    for (int k = 0; k < first.size(); k++) {
      first.get(k).source = k;
    }
    for (int i = 1; i < jobs.size(); i++) {
      for (Job reader : jobs.get(i)) {
        for (Job writer : jobs.get(i - 1)) {
          if (writer.write <= reader.read) {
            reader.source = writer.source;
          }
        }
      }
    }
  }

  /** Returns the longest reaction to an event that comes right after a job of the first task. */
  long reaction() {
    long longest = 0;
    for (int k = 0; k < jobs.get(0).size(); k++) {
      int missed = k;
      long event = jobs.get(0).get(k).read;
      long answer =
          jobs.get(jobs.size() - 1).stream()
              .filter(job -> job.source > missed)
              .mapToLong(job -> job.write)
              .min()
              .orElse(event);
      longest = event < settled ? longest : Math.max(longest, answer - event);
    }
    return longest;
  }

  /** Returns the oldest data that a job of the last task is based on when it ends. */
  long dataAge() {
    return jobs.get(jobs.size() - 1).stream()
        .filter(job -> job.source >= 0 && job.release >= settled)
        .mapToLong(job -> job.write - jobs.get(0).get(job.source).read)
        .max()
        .orElse(0);
  }
}

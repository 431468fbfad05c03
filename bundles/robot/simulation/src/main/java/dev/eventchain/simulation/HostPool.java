package dev.eventchain.simulation;

import dev.eventchain.simulation.host.NodeHosts;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntFunction;

/** Processes that do numbered jobs in parallel. */
final class HostPool {

  /** The number of no job. */
  private static final int NONE = -1;

  private final CaseSimulation.Numbers numbers;
  private final int most;
  private final IntFunction<NodeHosts> start;
  private final Job job;
  private final AtomicBoolean stopped = new AtomicBoolean();
  private final List<NodeHosts> open = new ArrayList<>();
  private final SortedMap<Integer, Throwable> failures = new TreeMap<>();

  /** A job on nodes in some processes. */
  interface Job {

    /** Does the job, or goes on with it after its earlier processes have ended. */
    State work(int number, NodeHosts hosts);
  }

  /** Remains of a job and of its processes. */
  enum State {
    /** The job is done, and the processes can do another one. */
    DONE,
    /** The job is done, and has ended the processes. */
    DONE_AT_THE_END,
    /** The job has ended the processes, and goes on in new ones. */
    UNDONE
  }

  /**
   * Creates a pool.
   *
   * @param jobs the number of jobs
   * @param start starts processes, given their index among those in parallel
   */
  HostPool(int jobs, IntFunction<NodeHosts> start, Job job) {
    this(upTo(jobs), jobs, start, job);
  }

  /**
   * Creates a pool.
   *
   * @param numbers the jobs
   * @param most how many of them there may be at the same time
   * @param start starts processes, given their index among those in parallel
   */
  HostPool(CaseSimulation.Numbers numbers, int most, IntFunction<NodeHosts> start, Job job) {
    this.numbers = numbers;
    this.most = most;
    this.start = start;
    this.job = job;
  }

  private static CaseSimulation.Numbers upTo(int jobs) {
    AtomicInteger next = new AtomicInteger();
    return new CaseSimulation.Numbers() {
      @Override
      public OptionalInt next() {
        int number = next.getAndIncrement();
        return number < jobs ? OptionalInt.of(number) : OptionalInt.empty();
      }

      @Override
      public void stop() {
        // Nobody waits.
      }
    };
  }

  /**
   * Does all jobs. The first failure, in the order of the jobs, is thrown after all have ended.
   *
   * @throws InterruptedException if the calling thread was interrupted; the processes are ended
   */
  void run(int parallel) throws InterruptedException {
    List<Thread> workers = new ArrayList<>();
    for (int i = 0; i < Math.min(parallel, most); i++) {
      int turn = i;
      Thread worker = new Thread(() -> work(turn), "simulation " + (i + 1));
      workers.add(worker);
      worker.start();
    }
    try {
      for (Thread worker : workers) {
        worker.join();
      }
    } catch (InterruptedException e) {
      stop(workers);
      throw e;
    }
    if (!failures.isEmpty()) {
      throwUnchecked(failures.get(failures.firstKey()));
    }
  }

  /** Ends the processes, which also ends the threads that wait for their answers. */
  private void stop(List<Thread> workers) throws InterruptedException {
    stopped.set(true);
    numbers.stop();
    synchronized (open) {
      open.forEach(NodeHosts::close);
    }
    for (Thread worker : workers) {
      worker.join();
    }
  }

  private static void throwUnchecked(Throwable failure) {
    if (failure instanceof Error error) {
      throw error;
    }
    throw (RuntimeException) failure;
  }

  /** Does jobs until none is left, with new processes after a job that ended its processes. */
  private void work(int turn) {
    int[] taken = {NONE};
    try {
      taken[0] = next();
      while (!stopped.get() && taken[0] != NONE) {
        workInOneProcess(turn, taken);
      }
    } catch (RuntimeException | Error e) { // rethrown by run(), so that no thread ends unnoticed
      failed(taken[0], e);
    }
  }

  private int next() {
    return numbers.next().orElse(NONE);
  }

  /**
   * Does jobs until none is left or one has ended the processes.
   *
   * @param taken the number of the current job; receives that of each further one
   */
  private void workInOneProcess(int turn, int[] taken) {
    NodeHosts hosts = start.apply(turn);
    synchronized (open) {
      open.add(hosts);
    }
    try {
      while (!stopped.get() && taken[0] != NONE) {
        State state = job.work(taken[0], hosts);
        if (state != State.UNDONE) {
          taken[0] = next();
        }
        if (state != State.DONE) {
          return;
        }
      }
    } finally {
      synchronized (open) {
        open.remove(hosts);
      }
      hosts.close();
    }
  }

  private synchronized void failed(int number, Throwable failure) {
    stopped.set(true);
    failures.put(number, failure);
    numbers.stop();
  }
}

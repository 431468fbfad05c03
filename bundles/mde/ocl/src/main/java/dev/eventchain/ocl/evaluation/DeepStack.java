package dev.eventchain.ocl.evaluation;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

/**
 * Runs evaluations in threads, if needed with a deep stack. Stack sizes are equal in all threads
 * and on all machines, and so are the limits of depth.
 */
public final class DeepStack {

  /** Enough for the deepest allowed recursion; memory is only used as the stack grows. */
  private static final long DEEP = 512L << 20;

  /** Enough for all but long recursions, so that many threads reserve little. */
  private static final long ORDINARY = 64L << 20;

  private static final long LONGEST_WAIT_MILLIS = 60_000;

  private DeepStack() {}

  /**
   * Runs a task in a thread with a deep stack; an interruption of this thread ends it.
   *
   * @throws IllegalStateException if this thread is interrupted meanwhile
   */
  public static <T> T call(Callable<T> task) {
    return all(List.of(task), DEEP).get(0);
  }

  /**
   * Runs tasks at the same time, each in its own thread. If one fails, or this thread is
   * interrupted, the others are interrupted, too; none is left running.
   */
  public static void runAll(List<Runnable> tasks) {
    List<Callable<Void>> calls = new ArrayList<>();
    for (Runnable task : tasks) {
      calls.add(
          () -> {
            task.run();
            return null;
          });
    }
    all(calls, ORDINARY);
  }

  private static <T> List<T> all(List<Callable<T>> tasks, long stack) {
    List<FutureTask<T>> futures = new ArrayList<>();
    List<Thread> threads = new ArrayList<>();
    for (Callable<T> task : tasks) {
      FutureTask<T> future = new FutureTask<>(task);
      futures.add(future);
      threads.add(new Thread(null, future, "eventchain-ocl-" + futures.size(), stack));
    }
    try {
      for (Thread thread : threads) {
        thread.setDaemon(true);
        thread.start();
      }
      List<T> results = new ArrayList<>();
      for (FutureTask<T> future : futures) {
        results.add(future.get());
      }
      return results;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted while evaluating", e);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof RuntimeException cause) {
        throw cause;
      } else if (e.getCause() instanceof Error cause) {
        throw cause;
      }
      throw new IllegalStateException(e.getCause());
    } finally {
      end(threads);
    }
  }

  /** Interrupts threads and waits for their end, for a limited time. */
  private static void end(List<Thread> threads) {
    boolean interrupted = Thread.interrupted();
    long until = System.nanoTime() + LONGEST_WAIT_MILLIS * 1_000_000;
    threads.forEach(Thread::interrupt);
    for (Thread thread : threads) {
      try {
        thread.join(Math.max(1, (until - System.nanoTime()) / 1_000_000));
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}

package dev.eventchain.ocl.evaluation;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

/**
 * Threads for evaluations, and a stack for those that need a deep one: the same in every thread and
 * on every machine, so that limits of depth are, too.
 */
public final class DeepStack {

  /** Room for the deepest recursion that is allowed; memory is only taken as far as it grows. */
  private static final long DEEP = 512L << 20;

  /** Enough for all but long recursions, so that many threads reserve little. */
  private static final long ORDINARY = 64L << 20;

  private static final long LONGEST_WAIT_MILLIS = 60_000;

  private DeepStack() {}

  /**
   * Does something in a thread with a deep stack; an interruption of this thread ends that.
   *
   * @throws IllegalStateException if this thread is interrupted meanwhile
   */
  public static <T> T call(Callable<T> task) {
    return all(List.of(task), DEEP).get(0);
  }

  /**
   * Does some things at the same time, each in its own thread. If one fails, or this thread is
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

  /** Ends threads and waits until they have ended, but not for ever for one that does not heed. */
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

package dev.eventchain.sandbox;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;

/** Threads that start processes and kill those that exceed their time. */
final class ProcessThreads {

  /**
   * A permanent thread that starts all processes. The kernel's parent-death signal, which ends a
   * confined process with this JVM, depends on the starting thread (prctl(2)).
   */
  private static final ExecutorService STARTER =
      Executors.newSingleThreadExecutor(task -> daemon(task, "confined-process-starter"));

  private static final ScheduledExecutorService CLOCK =
      Executors.newSingleThreadScheduledExecutor(task -> daemon(task, "confined-process-clock"));

  private ProcessThreads() {}

  static Process start(ProcessBuilder builder) throws IOException {
    Future<Process> started = STARTER.submit(builder::start);
    boolean interrupted = false;
    try {
      while (true) {
        try {
          return started.get();
        } catch (InterruptedException e) {
          interrupted = true; // the started process must not be lost
        } catch (ExecutionException e) {
          throw new IOException(e.getCause().getMessage(), e);
        }
      }
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  static ScheduledFuture<?> after(Duration delay, Runnable action) {
    return CLOCK.schedule(action, delay.toNanos(), TimeUnit.NANOSECONDS);
  }

  static Thread daemon(Runnable task, String name) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    return thread;
  }
}

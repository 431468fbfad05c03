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

/** The threads that start processes and end those whose time is over. */
final class ProcessThreads {

  /**
   * One thread that never ends starts all processes: the kernel's parent-death signal, by which a
   * confined process ends with this Java, goes by the thread that started it (prctl(2)).
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
          interrupted = true; // the process is owned by nobody until it is here
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

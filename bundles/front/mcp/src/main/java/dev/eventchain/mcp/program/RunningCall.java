package dev.eventchain.mcp.program;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;

/** A request that is being answered, until it has been answered or cancelled. */
public final class RunningCall {

  private static final Duration PATIENCE = Duration.ofSeconds(10);
  private static final long POLL_MS = 10;

  private final List<Process> processes = new ArrayList<>();
  private boolean cancelled;

  /**
   * Starts a process, which ends with the request.
   *
   * @throws CancellationException if the request is cancelled
   */
  synchronized Process start(ProcessBuilder builder) throws IOException {
    if (cancelled) {
      throw new CancellationException("the call was cancelled");
    }
    Process process = builder.start();
    processes.add(process);
    return process;
  }

  /**
   * Ends the processes of the request, as by SIGTERM, and by force what has not ended after some
   * seconds; starts no more.
   *
   * @return the processes that are ending
   */
  public synchronized List<ProcessHandle> cancel() {
    cancelled = true;
    List<ProcessHandle> all =
        processes.stream()
            .filter(Process::isAlive)
            .flatMap(it -> Stream.concat(it.descendants(), Stream.of(it.toHandle())))
            .toList();
    processes.forEach(Process::destroy);
    Thread patience = new Thread(() -> awaitEnd(all, PATIENCE), "patience");
    patience.setDaemon(true);
    patience.start();
    return all;
  }

  /** Waits for processes to end, and ends by force those that have not after a time. */
  public static void awaitEnd(List<ProcessHandle> processes, Duration patience) {
    long deadline = System.nanoTime() + patience.toNanos();
    try {
      while (processes.stream().anyMatch(RunningCall::runs)) {
        if (System.nanoTime() > deadline) {
          processes.forEach(ProcessHandle::destroyForcibly);
          return;
        }
        Thread.sleep(POLL_MS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Returns whether a process still runs; one that only waits to be noticed does not. */
  private static boolean runs(ProcessHandle process) {
    try {
      Path status = Path.of("/proc", Long.toString(process.pid()), "stat");
      String text = Files.readString(status);
      return process.isAlive() && text.charAt(text.lastIndexOf(')') + 2) != 'Z';
    } catch (IOException e) {
      return false; // It is gone.
    }
  }
}

package dev.eventchain.mcp.protocol;

import dev.eventchain.mcp.program.RunningCall;
import java.time.Duration;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The requests that are being answered, by their ids. */
final class RunningCalls {

  private final Map<String, RunningCall> running = new LinkedHashMap<>();
  private final Set<String> unanswered = new HashSet<>();

  /** Begins a request. */
  synchronized RunningCall begin(String id) {
    RunningCall call = new RunningCall();
    running.put(id, call);
    unanswered.remove(id);
    return call;
  }

  /**
   * Cancels a request, which then gets no answer; does nothing if it has been answered.
   *
   * @return the processes that are ending
   */
  List<ProcessHandle> cancel(String id) {
    RunningCall call;
    synchronized (this) {
      call = running.get(id);
      if (call == null) {
        return List.of();
      }
      unanswered.add(id);
    }
    return call.cancel();
  }

  /** Ends a request; returns whether its answer is still wanted. */
  synchronized boolean end(String id) {
    running.remove(id);
    notifyAll();
    return !unanswered.remove(id);
  }

  /** Waits until all requests have ended, which then have removed what they made, or for a time. */
  synchronized void awaitNone(Duration patience) {
    long deadline = System.nanoTime() + patience.toNanos();
    try {
      long left = patience.toMillis();
      while (!running.isEmpty() && left > 0) {
        wait(left);
        left = Duration.ofNanos(deadline - System.nanoTime()).toMillis();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Cancels all requests; returns the processes that are ending. */
  List<ProcessHandle> cancelAll() {
    List<String> ids;
    synchronized (this) {
      ids = List.copyOf(running.keySet());
    }
    return ids.stream().flatMap(id -> cancel(id).stream()).toList();
  }
}

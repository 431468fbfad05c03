package dev.eventchain.llm.service;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.concurrent.CancellationException;

/** The end of the time for a call, including its repetitions. */
public final class Deadline {
  private final Duration allowed;
  private final long end;

  private Deadline(Duration allowed) {
    this.allowed = allowed;
    this.end = System.nanoTime() + allowed.toNanos();
  }

  public static Deadline in(Duration time) {
    return new Deadline(time);
  }

  /** Returns the remaining time, at most the given time, and at least zero. */
  Duration atMost(Duration time) {
    Duration left = Duration.ofNanos(Math.max(0, end - System.nanoTime()));
    return left.compareTo(time) < 0 ? left : time;
  }

  Duration left() {
    return atMost(allowed);
  }

  boolean hasPassed() {
    return System.nanoTime() >= end;
  }

  CallFailure passed() {
    return new CallFailure(
        CallFailure.Kind.LATE,
        "there was no complete answer within " + text(allowed),
        "Allow more with 'deadline_s' of the service in eventchain.yaml, or ask a faster model.");
  }

  /** Returns the exception for an interrupted thread, and keeps its interrupt flag set. */
  public CancellationException interrupted() {
    Thread.currentThread().interrupt();
    return new CancellationException("the call was cancelled");
  }

  public static String text(Duration time) {
    return BigDecimal.valueOf(time.toMillis(), 3).stripTrailingZeros().toPlainString() + " s";
  }
}

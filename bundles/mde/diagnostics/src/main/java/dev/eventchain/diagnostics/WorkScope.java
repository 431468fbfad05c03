package dev.eventchain.diagnostics;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * Values that hold while some work is done; in inheritable ones, also for the threads it starts.
 */
final class WorkScope {

  private WorkScope() {}

  /** Returns the value of the innermost work; empty outside of any. */
  static <T> Optional<T> current(ThreadLocal<T> scope) {
    return Optional.ofNullable(scope.get());
  }

  /** Does work with a value. The one of the surrounding work holds again after it. */
  static <T, R> R during(ThreadLocal<T> scope, T value, Supplier<R> work) {
    T outer = scope.get();
    scope.set(value);
    try {
      return work.get();
    } finally {
      if (outer == null) {
        scope.remove();
      } else {
        scope.set(outer);
      }
    }
  }
}

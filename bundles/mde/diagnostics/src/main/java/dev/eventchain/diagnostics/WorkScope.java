package dev.eventchain.diagnostics;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * Value that holds while some work is done, also for the threads that the work starts.
 *
 * @param <T> the type of the value
 */
final class WorkScope<T> {

  private final InheritableThreadLocal<T> value = new InheritableThreadLocal<>();

  /** Returns the value of the innermost work; empty outside of any. */
  Optional<T> current() {
    return Optional.ofNullable(value.get());
  }

  /** Does work with a value. The one of the surrounding work holds again after it. */
  <R> R during(T inner, Supplier<R> work) {
    T outer = value.get();
    value.set(inner);
    try {
      return work.get();
    } finally {
      if (outer == null) {
        value.remove();
      } else {
        value.set(outer);
      }
    }
  }
}

package dev.eventchain.diagnostics;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/**
 * Early end of a piece of work whose result nobody wants any more. Those who do long work ask here,
 * and then know nothing of who wanted it. Work in threads that it starts belongs to it.
 */
public final class Cancellation {

  private static final Cancellation NEVER = new Cancellation(() -> false);

  private static final InheritableThreadLocal<Cancellation> CURRENT =
      new InheritableThreadLocal<>();

  private final BooleanSupplier isUnwanted;

  private Cancellation(BooleanSupplier isUnwanted) {
    this.isUnwanted = isUnwanted;
  }

  /** Thrown to end work whose result is not wanted; what it has found so far means nothing. */
  public static final class CancelledException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    private CancelledException() {
      super("the result is not wanted any more", null, false, false);
    }
  }

  /**
   * Does work that may end early.
   *
   * @param isUnwanted tells whether the result is not wanted any more; asked often, and by any
   *     thread. Once it is, it stays so, and the caller must not use the result
   * @throws CancelledException if the work has ended early by itself
   */
  public static <T> T during(BooleanSupplier isUnwanted, Supplier<T> work) {
    return WorkScope.during(CURRENT, new Cancellation(isUnwanted), work);
  }

  /** Returns that of the current work, also for threads that it did not start. */
  public static Cancellation current() {
    return WorkScope.current(CURRENT).orElse(NEVER);
  }

  /** Returns whether the result of the work is not wanted any more. */
  public boolean isRequested() {
    return isUnwanted.getAsBoolean();
  }

  /**
   * Ends the current work here if its result is not wanted any more.
   *
   * @throws CancelledException if it is not
   */
  public static void check() {
    if (current().isRequested()) {
      throw new CancelledException();
    }
  }
}

package dev.eventchain.simulation.run;

import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.function.Predicate;

/** The end of a run before its time, once its beginning shows all that matters. */
final class EarlyEnd {

  /** Simulated time between two looks at a run, in ns. */
  private static final long LOOK = 500_000_000L;

  private final Predicate<Trace> decided;
  private long next;

  private EarlyEnd(Predicate<Trace> decided, long next) {
    this.decided = decided;
    this.next = next;
  }

  /** Creates the early end of a run that has none. */
  static EarlyEnd never() {
    return new EarlyEnd(beginning -> false, Long.MAX_VALUE);
  }

  /**
   * Creates the early end of a run.
   *
   * @param decided returns whether the trace of a beginning shows all that matters
   */
  static EarlyEnd once(Predicate<Trace> decided) {
    return new EarlyEnd(decided, LOOK);
  }

  /** Returns whether the run ends now; its trace is cut then. */
  boolean isNow(World world, BenchDriver driver) {
    if (world.now() < next) {
      return false;
    }
    next = world.now() + LOOK;
    driver.expire(world);
    if (!decided.test(world.trace())) {
      return false;
    }
    world.trace().cutShort();
    return true;
  }
}

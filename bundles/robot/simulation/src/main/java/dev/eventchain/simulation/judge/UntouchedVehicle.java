package dev.eventchain.simulation.judge;

import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.List;

/**
 * Motion of a scenario's vehicle under its driver alone, for comparison with that under the
 * software.
 */
final class UntouchedVehicle {

  /** Tolerance for different step sizes, in m, m/s or rad. */
  private static final double ROUNDING = 1e-6;

  private UntouchedVehicle() {}

  /** Returns whether the ego moved as it does without any command, from the start to the end. */
  static boolean movedAs(Trace trace, Situation situation) {
    World world = new World(situation, new Trace());
    world.advanceTo(trace.end().time());
    List<Trace.State> with = trace.states();
    List<Trace.State> without = world.trace().states();
    if (with.size() != without.size()) {
      return false;
    }
    for (int i = 0; i < with.size(); i++) {
      if (!same(with.get(i), without.get(i))) {
        return false;
      }
    }
    return true;
  }

  private static boolean same(Trace.State with, Trace.State without) {
    return same(with.position(), without.position())
        && same(with.speed(), without.speed())
        && same(with.pose().offset(), without.pose().offset())
        && same(with.pose().heading(), without.pose().heading());
  }

  private static boolean same(double with, double without) {
    return Math.abs(with - without) <= ROUNDING;
  }
}

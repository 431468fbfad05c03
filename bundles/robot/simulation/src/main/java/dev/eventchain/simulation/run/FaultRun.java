package dev.eventchain.simulation.run;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.fault.Fault;
import dev.eventchain.simulation.fault.WorldFault;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.host.RunLog.Affected;
import java.util.Optional;

/**
 * A run with a fault.
 *
 * @param run the run; without a log if it was ended
 * @param world the fault's effect on the messages of the world
 * @param ended why the run ended early; empty if it did not
 */
public record FaultRun(Fault fault, ScenarioRun run, WorldFault world, Optional<Diagnostic> ended) {

  /** Returns the number of activations or messages that the fault altered. */
  public long affected() {
    return world.affected()
        + run.log().affected().values().stream().mapToLong(Affected::count).sum();
  }

  /**
   * Returns the time of the first effect of the fault, in ns; {@link RunLog#NEVER} if there was
   * none.
   */
  long first() {
    return run.log().affected().values().stream()
        .mapToLong(Affected::first)
        .reduce(world.first(), Math::min);
  }

  /**
   * Returns whether the fault had an effect before the end of the run. A run that ended early has
   * no log; a fault that had begun counts as its cause.
   */
  public boolean tookEffect() {
    long end = run.trace().end().time();
    return ended.isPresent() ? fault.start() <= end : first() < end;
  }
}

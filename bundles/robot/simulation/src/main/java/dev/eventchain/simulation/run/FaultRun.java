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
 * @param run what happened; without a log if it was ended
 * @param world what the fault did to the world's messages
 * @param ended why it could not go on to its end; empty if it did
 */
public record FaultRun(Fault fault, ScenarioRun run, WorldFault world, Optional<Diagnostic> ended) {

  /** How many activations or messages the fault has changed. */
  public long affected() {
    return world.affected()
        + run.log().affected().values().stream().mapToLong(Affected::count).sum();
  }

  /** When the fault first made a difference, in ns; {@link RunLog#NEVER} if it never did. */
  long first() {
    return run.log().affected().values().stream()
        .mapToLong(Affected::first)
        .reduce(world.first(), Math::min);
  }

  /**
   * Whether it made a difference to something before the run was over. Of one that was ended there
   * is no record; a fault that had begun is what ended it.
   */
  public boolean tookEffect() {
    long end = run.trace().end().time();
    return ended.isPresent() ? fault.start() <= end : first() < end;
  }
}

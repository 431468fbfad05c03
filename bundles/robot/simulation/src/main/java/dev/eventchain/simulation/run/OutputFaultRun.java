package dev.eventchain.simulation.run;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.host.RunLog.Affected;
import java.util.Optional;

/**
 * A run with a standard fault of an output.
 *
 * @param run the run; without a log if it was ended
 * @param ended why the run ended early; empty if it did not
 */
public record OutputFaultRun(OutputFault fault, ScenarioRun run, Optional<Diagnostic> ended) {

  /** Returns whether the fault changed a message; one that ended the run did. */
  public boolean tookEffect() {
    Affected affected = run.log().affected().get(fault.node());
    return ended.isPresent() || (affected != null && affected.count() > 0);
  }

  /** Returns the simulated time, in ns. */
  public long simulated() {
    return run.trace().states().isEmpty() ? 0 : run.trace().end().time();
  }
}

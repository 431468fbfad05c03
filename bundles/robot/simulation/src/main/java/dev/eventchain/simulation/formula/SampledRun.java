package dev.eventchain.simulation.formula;

import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.HashMap;
import java.util.Map;

/**
 * A trace as formulas see it: a sample every 10 ms, each holding until the next one. The instant of
 * an impact, which ends a trace between two samples, counts as the one that was due next.
 */
public final class SampledRun {

  private final Trace trace;
  private final Map<String, double[]> values = new HashMap<>();

  public SampledRun(Trace trace) {
    this.trace = trace;
  }

  int size() {
    return trace.states().size();
  }

  /** When a sample was taken, in s. */
  double seconds(int sample) {
    return World.seconds(trace.states().get(sample).time());
  }

  Trace trace() {
    return trace;
  }

  double[] of(Signal signal) {
    return values.computeIfAbsent(signal.name(), name -> signal.samples().apply(trace));
  }
}

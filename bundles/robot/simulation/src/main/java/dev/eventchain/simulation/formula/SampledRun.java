package dev.eventchain.simulation.formula;

import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.HashMap;
import java.util.Map;

/**
 * A trace sampled for formulas every 10 ms; each sample holds until the next one. The instant of an
 * impact, which ends a trace between two samples, counts as the next sample.
 */
public final class SampledRun {

  private final Trace trace;
  private final boolean cut;
  private final Map<String, double[]> values = new HashMap<>();

  public SampledRun(Trace trace) {
    this(trace, trace.isCut());
  }

  private SampledRun(Trace trace, boolean cut) {
    this.trace = trace;
    this.cut = cut;
  }

  /** Returns the beginning of a run that goes on: what comes after it is unknown. */
  public static SampledRun beginning(Trace trace) {
    return new SampledRun(trace, true);
  }

  int size() {
    return trace.states().size();
  }

  /** Returns the time of a sample, in s. */
  double seconds(int sample) {
    return World.seconds(trace.states().get(sample).time());
  }

  /** Returns whether the run ended before its time, so that what comes after it is unknown. */
  boolean isCut() {
    return cut;
  }

  Trace trace() {
    return trace;
  }

  double[] of(Signal signal) {
    return values.computeIfAbsent(signal.name(), name -> signal.samples().apply(trace));
  }
}

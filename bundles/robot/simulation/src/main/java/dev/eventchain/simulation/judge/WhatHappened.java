package dev.eventchain.simulation.judge;

import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Curve;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Figure;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Series;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Statistic;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.List;

/** Figures and curves of the signals of a trace, independent of the tested function. */
final class WhatHappened {

  private static final long SERIES_STEP = 50_000_000L;

  private WhatHappened() {}

  /** Returns the minimum and maximum of each signal, and the speed of an impact. */
  static List<Figure> figures(Trace trace, List<Signal> signals) {
    List<Figure> figures = new ArrayList<>();
    for (Signal signal : signals) {
      if (!signal.truth() && signal.absence().apply(trace).isEmpty()) {
        double[] values = signal.samples().apply(trace);
        extreme(figures, signal, Statistic.MINIMUM, trace, values);
        extreme(figures, signal, Statistic.MAXIMUM, trace, values);
      }
    }
    double end = World.seconds(trace.end().time());
    trace
        .impactSpeed()
        .ifPresent(
            speed -> figures.add(new Figure("impact.speed", "m/s", Statistic.FINAL, speed, end)));
    return figures;
  }

  /** Adds an extreme value; infinite ones, such as the TTC without an approach, are left out. */
  private static void extreme(
      List<Figure> figures, Signal signal, Statistic statistic, Trace trace, double[] values) {
    double sign = statistic == Statistic.MINIMUM ? 1 : -1;
    int found = -1;
    for (int i = 0; i < values.length; i++) {
      if (Double.isFinite(values[i]) && (found < 0 || sign * values[i] < sign * values[found])) {
        found = i;
      }
    }
    if (found >= 0) {
      double time = World.seconds(trace.states().get(found).time());
      double value = signal.inUnit(values[found]);
      figures.add(new Figure(signal.name(), signal.unit(), statistic, value, time));
    }
  }

  /** Returns the curves of the signals, and the scene. */
  static Series series(Situation situation, Trace trace, List<Signal> signals) {
    List<Trace.State> states = trace.states();
    List<Integer> kept = new ArrayList<>();
    for (int i = 0; i < states.size(); i++) {
      if (states.get(i).time() % SERIES_STEP == 0 || i == states.size() - 1) {
        kept.add(i);
      }
    }
    List<Double> times = kept.stream().map(i -> World.seconds(states.get(i).time())).toList();
    List<Curve> curves =
        signals.stream()
            .map(
                signal -> {
                  double[] values = signal.samples().apply(trace);
                  return new Curve(
                      signal.name(),
                      signal.unit(),
                      signal.absence().apply(trace).orElse(""),
                      kept.stream().map(i -> signal.inUnit(values[i])).toList());
                })
            .toList();
    List<Trace.State> shown = kept.stream().map(states::get).toList();
    return new Series(times, curves, SceneFromAbove.of(situation, trace, shown));
  }
}

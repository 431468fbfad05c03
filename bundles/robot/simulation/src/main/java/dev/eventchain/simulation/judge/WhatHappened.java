package dev.eventchain.simulation.judge;

import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.Curve;
import dev.eventchain.simulation.verdict.Happened;
import dev.eventchain.simulation.verdict.Happened.Kind;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Figure;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Series;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Statistic;
import dev.eventchain.simulation.world.Director;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/** Figures and curves of the signals of a trace, independent of the tested function. */
final class WhatHappened {

  private static final long SERIES_STEP = 50_000_000L;

  private WhatHappened() {}

  /** Returns the minimum and maximum of each signal, and the speed of an impact. */
  static List<Figure> figures(Trace trace, List<Signal> signals) {
    List<Figure> figures = new ArrayList<>();
    for (Signal signal : signals) {
      if (!signal.truth() && !signal.named().isText() && signal.absence().apply(trace).isEmpty()) {
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

  /** Returns the events of a storyboard, and when it handed over and ended; nothing without one. */
  static List<Happened> happened(Scenario scenario, Trace trace) {
    List<Happened> all = new ArrayList<>();
    if (scenario.situation().director().isEmpty()) {
      return all;
    }
    for (Director.Happening each : trace.happenings()) {
      double time = World.seconds(each.time());
      if (each.begins()) {
        all.add(new Happened(each.event(), Kind.EVENT, time, OptionalDouble.empty()));
      } else {
        end(all, each.event(), time);
      }
    }
    taken(all, "the software takes the pedals", trace.pedalsTaken());
    taken(all, "the software takes the wheel", trace.wheelTaken());
    long end = trace.end().time();
    boolean over = end < World.nanoseconds(scenario.duration()) && trace.impactSpeed().isEmpty();
    if (over && !trace.isCut() && scenario.situation().end().isEmpty()) {
      all.add(
          new Happened(
              "the storyboard ends", Kind.END, World.seconds(end), OptionalDouble.empty()));
    }
    all.sort(Comparator.comparingDouble(Happened::start));
    return all;
  }

  /** Ends the last begin of an event, which may happen several times. */
  private static void end(List<Happened> all, String event, double time) {
    for (int i = all.size() - 1; i >= 0; i--) {
      Happened begun = all.get(i);
      if (begun.name().equals(event) && begun.end().isEmpty()) {
        all.set(i, new Happened(event, Kind.EVENT, begun.start(), OptionalDouble.of(time)));
        return;
      }
    }
  }

  private static void taken(List<Happened> all, String words, OptionalLong time) {
    time.ifPresent(
        at ->
            all.add(new Happened(words, Kind.TAKEOVER, World.seconds(at), OptionalDouble.empty())));
  }

  private static List<Curve.Name> names(Signal signal) {
    return signal.named().values().stream()
        .map(each -> new Curve.Name(each.number(), each.name()))
        .toList();
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
                      kept.stream().map(i -> signal.inUnit(values[i])).toList(),
                      names(signal));
                })
            .toList();
    List<Trace.State> shown = kept.stream().map(states::get).toList();
    return new Series(times, curves, SceneFromAbove.of(situation, trace, shown));
  }
}

package dev.eventchain.simulation.formula;

import java.util.List;
import java.util.Optional;

/**
 * Operators about the samples up to one. An interval counts as far as it is in the run; where all
 * of it is before the start, they are unknown.
 */
final class Past {

  private Past() {}

  /** Returns an interval that reaches back, as one relative to a sample. */
  private static Interval back(Interval interval, int nearest) {
    int farthest = interval.bounded() ? -interval.to() : Integer.MIN_VALUE / 2;
    return new Interval(farthest, -nearest, true);
  }

  /** Returns what to say of an operator about the past that sees nothing of the run. */
  static Optional<String> nothingBefore(Condition condition) {
    return condition instanceof Temporal || condition instanceof Since
        ? Optional.of("all of its interval is before the start of the run, so ask for it later")
        : Optional.empty();
  }

  /** {@code historically}, or {@code once}: true at all samples, or at one, of an interval. */
  record Temporal(boolean always, Interval interval, Condition operand) implements Condition {

    @Override
    public boolean ofOneMoment() {
      return false;
    }

    @Override
    public List<Condition> parts() {
      return List.of(operand);
    }

    @Override
    public double[] truth(SampledRun run, List<double[]> parts) {
      double[] truth = parts.get(0);
      return always
          ? Robustness.not(Robustness.once(Robustness.not(truth), interval))
          : Robustness.once(truth, interval);
    }

    @Override
    public Interval window(int part) {
      return back(interval, interval.from());
    }

    /** Returns the first sample of the window with the extreme value. */
    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      double[] truth = parts.get(0);
      int found = interval.bounded() ? Math.max(0, sample - interval.to()) : 0;
      for (int i = found; i <= sample - interval.from(); i++) {
        if (always ? truth[i] < truth[found] : truth[i] > truth[found]) {
          found = i;
        }
      }
      return sample < interval.from() ? Step.OUTSIDE : new Step(0, found);
    }
  }

  /** {@code kept since reached}: true at a sample of an interval, and kept at each one after it. */
  record Since(Condition kept, Interval interval, Condition reached) implements Condition {

    @Override
    public boolean ofOneMoment() {
      return false;
    }

    @Override
    public List<Condition> parts() {
      return List.of(kept, reached);
    }

    @Override
    public double[] truth(SampledRun run, List<double[]> parts) {
      return Robustness.since(parts.get(0), parts.get(1), interval);
    }

    @Override
    public Interval window(int part) {
      return back(interval, part == 1 ? interval.from() : 0);
    }

    /** Decides as {@code until} does in the run that is read from its end. */
    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      if (sample < interval.from()) {
        return Step.OUTSIDE;
      }
      int last = parts.get(0).length - 1;
      boolean open = interval.bounded() && interval.to() > sample;
      Interval within = open ? new Interval(interval.from(), sample, true) : interval;
      List<double[]> reversed = parts.stream().map(Since::reversed).toList();
      Step step =
          new Condition.Until(kept, within, reached).decisive(reversed, last - sample, false);
      return step.part() < 0 ? step : new Step(step.part(), last - step.sample());
    }

    private static double[] reversed(double[] values) {
      double[] result = new double[values.length];
      for (int i = 0; i < values.length; i++) {
        result[i] = values[values.length - 1 - i];
      }
      return result;
    }
  }
}

package dev.eventchain.simulation.formula;

import java.util.List;

/**
 * Operators about the samples up to one. They are those of the future in a run that is read from
 * its end, but for one thing: before the start there is nothing, while what comes after the end of
 * a run may be unknown.
 */
final class Past {

  private Past() {}

  /** Returns an interval that reaches back, as one relative to a sample. */
  private static Interval back(Interval interval, int nearest) {
    int farthest = interval.bounded() ? -interval.to() : Integer.MIN_VALUE / 2;
    return new Interval(farthest, -nearest, true);
  }

  private static double[] reversed(double[] values) {
    double[] result = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      result[i] = values[values.length - 1 - i];
    }
    return result;
  }

  /** Returns the deciding step of an operator of the future, read from the end of the run. */
  private static Condition.Step mirrored(
      Condition future, List<double[]> parts, int sample, Interval interval) {
    int last = parts.get(0).length - 1;
    if (interval.from() > sample) {
      return Condition.Step.OUTSIDE;
    }
    Condition.Step step =
        future.decisive(parts.stream().map(Past::reversed).toList(), last - sample, false);
    return step.part() < 0 ? step : new Condition.Step(step.part(), last - step.sample());
  }

  /** Returns the interval that reaches back to the start at most, so that none is open. */
  private static Interval within(Interval interval, int sample) {
    return interval.bounded() && interval.to() > sample
        ? new Interval(interval.from(), Math.max(interval.from(), sample), true)
        : interval;
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

    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      Condition future = new Condition.Temporal(always, within(interval, sample), operand);
      return mirrored(future, parts, sample, interval);
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

    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      Condition future = new Condition.Until(kept, within(interval, sample), reached);
      return mirrored(future, parts, sample, interval);
    }
  }
}

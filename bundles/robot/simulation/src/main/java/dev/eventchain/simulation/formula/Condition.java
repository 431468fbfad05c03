package dev.eventchain.simulation.formula;

import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Stream;

/** A formula, or a part of one, with a truth value at each sample. See {@link Robustness}. */
public interface Condition extends FormulaParser.Part {

  /** Returns the operands. */
  default List<Condition> parts() {
    return List.of();
  }

  /** Returns the truth at each sample, from that of the parts. */
  double[] truth(SampledRun run, List<double[]> parts);

  /**
   * Returns the interval in which a part is evaluated, relative to the sample of this condition.
   */
  default Interval window(int part) {
    return new Interval(0, 0, true);
  }

  /**
   * Returns the part, and its sample, that decides the truth at a sample: of several the first one,
   * but of an implication the conclusion.
   *
   * @param cut true if intervals without a bound reach beyond the last sample
   */
  default Step decisive(List<double[]> parts, int sample, boolean cut) {
    throw new IllegalStateException("It has no parts.");
  }

  /**
   * Returns why the truth says nothing about the software; empty if it does.
   *
   * @param first the first evaluated sample
   * @param last the last evaluated sample
   */
  default Optional<String> vacuity(SampledRun run, List<double[]> parts, int first, int last) {
    return Optional.empty();
  }

  /** Returns whether the margins of its comparisons have the same unit. */
  default boolean oneUnit() {
    List<Comparison> comparisons = comparisons().toList();
    return comparisons.stream()
        .allMatch(
            it ->
                it.left().comparesWith(comparisons.get(0).left())
                    && it.ofTruth() == comparisons.get(0).ofTruth());
  }

  /** Sample beyond every run. */
  long NO_END = 1L << 32;

  /** Returns the last sample that its intervals reach from a sample. */
  default long horizon(long sample) {
    long last = sample;
    for (int i = 0; i < parts().size(); i++) {
      Interval interval = window(i);
      long from = interval.bounded() ? sample + interval.to() : NO_END;
      last = Math.max(last, parts().get(i).horizon(from));
    }
    return last;
  }

  /** Returns whether its truth at a sample depends on that sample only. */
  default boolean ofOneMoment() {
    return parts().stream().allMatch(Condition::ofOneMoment);
  }

  /** Returns the comparisons in it. */
  default Stream<Comparison> comparisons() {
    return parts().stream().flatMap(Condition::comparisons);
  }

  /**
   * A step towards the deciding comparison.
   *
   * @param part the number of the part; -1 if the start or the end of the run decides
   */
  record Step(int part, int sample) {
    static final Step OUTSIDE = new Step(-1, -1);
  }

  /** {@code left < right} or {@code left <= right}, with its source text. */
  record Comparison(Term left, Term right, boolean strict, String text) implements Condition {

    /** Returns the comparison that a Boolean signal is true, that is 1 and not 0. */
    static Comparison isTrue(Term term, String text) {
      return new Comparison(Term.number(0.5, term.dimension(), "1"), term, true, text);
    }

    /** Returns all signals that it reads. */
    Stream<Signal> signals() {
      return Stream.concat(left.signals().stream(), right.signals().stream());
    }

    /** Returns whether it compares Boolean signals, so that its margin has no meaning. */
    boolean ofTruth() {
      return left.truth() || right.truth();
    }

    @Override
    public double[] truth(SampledRun run, List<double[]> parts) {
      IntToDoubleFunction smaller = left.values().in(run);
      IntToDoubleFunction larger = right.values().in(run);
      double[] truth = new double[run.size()];
      for (int i = 0; i < truth.length; i++) {
        truth[i] = Robustness.less(smaller.applyAsDouble(i), larger.applyAsDouble(i), strict);
      }
      return truth;
    }

    @Override
    public Stream<Comparison> comparisons() {
      return Stream.of(this);
    }

    /** Returns the difference of its sides, which is positive where it is true. */
    Sum difference() {
      return right.sum().plus(left.sum(), -1.0);
    }

    /** Returns the named value with which a signal is compared; empty for quantities. */
    Optional<NamedPart> named() {
      return difference().named();
    }

    /** Returns what is known of its sides, for users. */
    String values(Range.Source ranges) {
      return signals()
          .map(signal -> signal.values(signal.range().apply(ranges)))
          .filter(text -> !text.isEmpty())
          .findFirst()
          .orElse("Compare it with something that could be otherwise.");
    }

    /** Returns the limit of a signal, if one side is a signal and the other depends on none. */
    Optional<ScenarioVerdict.Limit> limit(SampledRun run) {
      return ofTruth() ? Optional.empty() : left.limit(right, run).or(() -> right.limit(left, run));
    }

    @Override
    public Optional<String> vacuity(SampledRun run, List<double[]> parts, int first, int last) {
      return left.absence(run.trace()).or(() -> right.absence(run.trace()));
    }
  }

  /** {@code not}. */
  record Negation(Condition operand) implements Condition {

    @Override
    public List<Condition> parts() {
      return List.of(operand);
    }

    @Override
    public double[] truth(SampledRun run, List<double[]> parts) {
      return Robustness.not(parts.get(0));
    }

    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      return new Step(0, sample);
    }
  }

  /** {@code and} if {@code all} is set, otherwise {@code or}. */
  record Junction(boolean all, Condition first, Condition second) implements Condition {

    @Override
    public List<Condition> parts() {
      return List.of(first, second);
    }

    @Override
    public double[] truth(SampledRun run, List<double[]> parts) {
      double[] one = parts.get(0);
      double[] other = parts.get(1);
      return all ? Robustness.and(one, other) : Robustness.or(one, other);
    }

    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      double one = parts.get(0)[sample];
      double other = parts.get(1)[sample];
      return new Step((all ? one <= other : one >= other) ? 0 : 1, sample);
    }
  }

  /** {@code premise implies conclusion}, with the source text of the premise. */
  record Implication(Condition premise, Condition conclusion, String text) implements Condition {

    @Override
    public List<Condition> parts() {
      return List.of(premise, conclusion);
    }

    @Override
    public double[] truth(SampledRun run, List<double[]> parts) {
      return Robustness.or(Robustness.not(parts.get(0)), parts.get(1));
    }

    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      return new Step(-parts.get(0)[sample] > parts.get(1)[sample] ? 0 : 1, sample);
    }

    @Override
    public Optional<String> vacuity(SampledRun run, List<double[]> parts, int first, int last) {
      double[] truth = parts.get(0);
      for (int i = first; i <= last; i++) {
        if (truth[i] > 0.0) {
          return Optional.empty();
        }
      }
      return Optional.of("'" + text + "' never came true");
    }
  }

  /** {@code always}, or {@code eventually}. */
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
          ? Robustness.always(truth, interval, run.isCut())
          : Robustness.eventually(truth, interval, run.isCut());
    }

    @Override
    public Interval window(int part) {
      return interval;
    }

    /**
     * Returns the first sample of the window with the extreme value; none if that is unknown there.
     */
    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      double[] truth = parts.get(0);
      double extreme = always ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
      int found = -1;
      for (int i = sample + interval.from(); i <= interval.last(sample, truth.length); i++) {
        if (found < 0 || (always ? truth[i] < extreme : truth[i] > extreme)) {
          extreme = truth[i];
          found = i;
        }
      }
      boolean open = interval.bounded() ? sample + interval.to() >= truth.length : cut;
      boolean beyond = open && (always ? extreme > 0.0 : extreme < 0.0);
      return found < 0 || beyond ? Step.OUTSIDE : new Step(0, found);
    }
  }

  /** {@code kept until reached}. */
  record Until(Condition kept, Interval interval, Condition reached) implements Condition {

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
      return Robustness.until(parts.get(0), parts.get(1), interval, run.isCut());
    }

    @Override
    public Interval window(int part) {
      return part == 1 ? interval : new Interval(0, interval.to(), interval.bounded());
    }

    /** Applies the definition: the best sample for {@code reached}, or the worst one before it. */
    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      double best = Double.NEGATIVE_INFINITY;
      Step found = Step.OUTSIDE;
      double worst = Double.POSITIVE_INFINITY;
      int worstAt = sample;
      int last = interval.last(sample, parts.get(0).length);
      for (int i = sample; i <= last; i++) {
        double there = parts.get(1)[i];
        double truth = Math.min(there, worst);
        if (i >= sample + interval.from() && (truth > best || found.equals(Step.OUTSIDE))) {
          best = truth;
          found = there <= worst ? new Step(1, i) : new Step(0, worstAt);
        }
        if (parts.get(0)[i] < worst) {
          worst = parts.get(0)[i];
          worstAt = i;
        }
      }
      boolean open = interval.bounded() ? sample + interval.to() >= parts.get(0).length : cut;
      if (!open || best >= Robustness.UNKNOWN) {
        return found;
      }
      // After the run, "reached" may still come unless "kept" failed before.
      if (worst < Robustness.UNKNOWN) {
        return worst >= best ? new Step(0, worstAt) : found;
      }
      return worst == Robustness.UNKNOWN ? new Step(0, worstAt) : Step.OUTSIDE;
    }
  }

  /** {@code rise}: true at a sample and false at the one before. */
  record Rise(Condition operand) implements Condition {

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
      return Robustness.rise(parts.get(0));
    }

    @Override
    public Interval window(int part) {
      return new Interval(-1, 0, true);
    }

    @Override
    public Step decisive(List<double[]> parts, int sample, boolean cut) {
      if (sample == 0) {
        return Step.OUTSIDE;
      }
      double now = parts.get(0)[sample];
      return new Step(0, now <= -parts.get(0)[sample - 1] ? sample : sample - 1);
    }
  }
}

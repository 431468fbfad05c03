package dev.eventchain.simulation.formula;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Truth of a condition and of its parts in a run. If all comparisons have one dimension, the truth
 * has margins; otherwise it is a verdict: 1, -1 or 0.
 */
final class FormulaEvaluation {

  private final Condition condition;
  private final double[] truth;
  private final List<FormulaEvaluation> parts;
  private final Optional<String> vacuity;
  private final boolean cut;

  /** Margins of a comparison, also where its parents have verdicts only. */
  private final double[] margins;

  private FormulaEvaluation(
      Condition condition,
      double[] margins,
      boolean oneUnit,
      List<FormulaEvaluation> parts,
      Optional<String> vacuity,
      boolean cut) {
    this.condition = condition;
    this.margins = margins;
    this.truth = oneUnit ? margins : verdicts(margins);
    this.parts = parts;
    this.vacuity = vacuity;
    this.cut = cut;
  }

  /** Evaluates a condition at the start of a run. */
  static FormulaEvaluation of(Condition condition, SampledRun run) {
    return new Evaluator(run, false, condition.oneUnit()).evaluate(condition, 0, 0);
  }

  /** Returns the truth of a condition of one moment at each sample. */
  static double[] truth(Condition condition, SampledRun run) {
    return new Evaluator(run, false, false).evaluate(condition, 0, run.size() - 1).truth;
  }

  /**
   * Evaluates as {@link #of} does, but truth that says nothing about the software is unknown: an
   * implication whose premise never came true, or a comparison of signals without values.
   */
  static FormulaEvaluation strictly(Condition condition, SampledRun run) {
    return new Evaluator(run, true, condition.oneUnit()).evaluate(condition, 0, 0);
  }

  private static double[] verdicts(double[] margins) {
    return Arrays.stream(margins).map(Math::signum).toArray();
  }

  /**
   * Evaluation of a whole formula.
   *
   * @param strictly true if vacuous truth is unknown
   * @param oneUnit true if margins are propagated, false if verdicts are
   */
  private record Evaluator(SampledRun run, boolean strictly, boolean oneUnit) {

    /**
     * Evaluates a condition at all samples; {@code first} and {@code last} bound the samples that
     * count.
     */
    FormulaEvaluation evaluate(Condition condition, int first, int last) {
      int size = run.size();
      List<FormulaEvaluation> parts = new ArrayList<>();
      for (int i = 0; i < condition.parts().size(); i++) {
        Interval window = condition.window(i);
        int from = Math.max(0, first + window.from());
        parts.add(evaluate(condition.parts().get(i), from, window.last(last, size)));
      }
      List<double[]> inner = parts.stream().map(part -> part.truth).toList();
      Optional<String> vacuity =
          strictly ? condition.vacuity(run, inner, first, last) : Optional.empty();
      double[] truth = vacuity.isPresent() ? new double[size] : condition.truth(run, inner);
      return new FormulaEvaluation(condition, truth, oneUnit, parts, vacuity, run.isCut());
    }
  }

  /**
   * Returns whether it is unknown at the start although the run came to something that it asks for.
   * Of a conjunction or a disjunction at the start, only the unknown parts count.
   */
  boolean isOpen() {
    return condition instanceof Condition.Junction
        ? parts.stream().anyMatch(FormulaEvaluation::isOpen)
        : verdict() == Robustness.UNKNOWN && asks();
  }

  /**
   * Returns whether it asks for something that is behind no premise, or behind premises all of
   * which came true: an implication asks for what its conclusion asks for, once its premise holds.
   */
  private boolean asks() {
    if (condition instanceof Condition.Implication) {
      return vacuity.isEmpty() && parts.get(1).asks();
    }
    return parts.isEmpty() || parts.stream().anyMatch(FormulaEvaluation::asks);
  }

  /** Returns the truth at the start, see {@link Robustness}. */
  double verdict() {
    return truth[0];
  }

  /**
   * Reason for the truth of a condition.
   *
   * @param comparison the deciding comparison; empty if the start or the end of the run or a
   *     vacuous part decides
   * @param sample its sample
   * @param truth the truth of the comparison at that sample: under a negation it holds where the
   *     formula fails
   * @param otherwise the samples next to it at which the comparison is the other way round
   * @param vacuity the reason why that part is vacuous; empty if it is not
   */
  record Decision(
      Optional<Condition.Comparison> comparison,
      int sample,
      double truth,
      List<Integer> otherwise,
      Optional<String> vacuity) {

    static Decision without(int sample, Optional<String> vacuity) {
      return new Decision(Optional.empty(), sample, Robustness.UNKNOWN, List.of(), vacuity);
    }
  }

  /** Follows the deciding parts from the condition at the start down to a comparison. */
  Decision decision() {
    FormulaEvaluation here = this;
    int sample = 0;
    while (here.vacuity.isEmpty()) {
      if (here.condition instanceof Condition.Comparison comparison) {
        return new Decision(
            Optional.of(comparison),
            sample,
            here.margins[sample],
            here.otherwise(sample),
            Optional.empty());
      }
      List<double[]> inner = here.parts.stream().map(part -> part.truth).toList();
      Condition.Step step = here.condition.decisive(inner, sample, cut);
      if (step.part() < 0) {
        return Decision.without(sample, Past.nothingBefore(here.condition));
      }
      here = here.parts.get(step.part());
      sample = step.sample();
    }
    return Decision.without(sample, here.vacuity);
  }

  /** Returns the last sample before, and the first after, at which the truth is the opposite. */
  private List<Integer> otherwise(int sample) {
    IntPredicate isOpposite = i -> margins[i] * margins[sample] < 0.0;
    IntStream before = IntStream.iterate(sample - 1, i -> i >= 0, i -> i - 1);
    IntStream after = IntStream.range(sample + 1, margins.length);
    return Stream.of(before, after)
        .flatMap(samples -> samples.filter(isOpposite).boxed().limit(1))
        .toList();
  }
}

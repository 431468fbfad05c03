package dev.eventchain.simulation.formula;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The truth of a condition in a run, and that of its parts. If all that it compares is of one
 * dimension, the truth has margins; if not, it is a verdict: 1, -1 or 0.
 */
final class FormulaEvaluation {

  private final Condition condition;
  private final double[] truth;
  private final List<FormulaEvaluation> parts;
  private final Optional<String> vacuity;

  /** The margins of a comparison, also where only verdicts go up to what it is a part of. */
  private final double[] margins;

  private FormulaEvaluation(
      Condition condition,
      double[] margins,
      boolean oneUnit,
      List<FormulaEvaluation> parts,
      Optional<String> vacuity) {
    this.condition = condition;
    this.margins = margins;
    this.truth = oneUnit ? margins : verdicts(margins);
    this.parts = parts;
    this.vacuity = vacuity;
  }

  /** Evaluates a condition at the start of a run. */
  static FormulaEvaluation of(Condition condition, SampledRun run) {
    return new Evaluator(run, false, condition.oneUnit()).evaluate(condition, 0, 0);
  }

  /**
   * As {@link #of}, but what is true without saying anything of the software is not known: an
   * implication whose premise never came true, and what compares signals that say nothing.
   */
  static FormulaEvaluation strictly(Condition condition, SampledRun run) {
    return new Evaluator(run, true, condition.oneUnit()).evaluate(condition, 0, 0);
  }

  private static double[] verdicts(double[] margins) {
    return Arrays.stream(margins).map(Math::signum).toArray();
  }

  /**
   * How a whole formula is evaluated.
   *
   * @param strictly whether what is vacuous is unknown
   * @param oneUnit whether margins go up, or else verdicts
   */
  private record Evaluator(SampledRun run, boolean strictly, boolean oneUnit) {

    /** Evaluates at all samples; it is looked at from the first to the last of those given. */
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
      return new FormulaEvaluation(condition, truth, oneUnit, parts, vacuity);
    }
  }

  /** The truth at the start, see {@link Robustness}. */
  double verdict() {
    return truth[0];
  }

  /**
   * What gave a condition its truth.
   *
   * @param comparison empty if none did, but the start or the end of the run, or a vacuous part
   * @param sample when
   * @param truth that of the comparison then: under a negation it holds where the formula fails
   * @param vacuity why that part says nothing; empty if it does not
   */
  record Decision(
      Optional<Condition.Comparison> comparison,
      int sample,
      double truth,
      Optional<String> vacuity) {}

  /** Goes down from the condition at the start, each time to the part that decides. */
  Decision decision() {
    FormulaEvaluation here = this;
    int sample = 0;
    while (here.vacuity.isEmpty()) {
      if (here.condition instanceof Condition.Comparison comparison) {
        return new Decision(
            Optional.of(comparison), sample, here.margins[sample], Optional.empty());
      }
      List<double[]> inner = here.parts.stream().map(part -> part.truth).toList();
      Condition.Step step = here.condition.decisive(inner, sample);
      if (step.part() < 0) {
        return new Decision(Optional.empty(), sample, Robustness.UNKNOWN, Optional.empty());
      }
      here = here.parts.get(step.part());
      sample = step.sample();
    }
    return new Decision(Optional.empty(), sample, Robustness.UNKNOWN, here.vacuity);
  }
}

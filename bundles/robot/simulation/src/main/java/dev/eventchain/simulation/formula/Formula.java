package dev.eventchain.simulation.formula;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Limit;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * A formula of Signal Temporal Logic over the run of a scenario. A run is a sequence of samples,
 * see {@link SampledRun}; the formula is judged at the first of them.
 *
 * <p>The verdict is exact and three-valued. Unknown are samples beyond the end of a run that ended
 * early, and comparisons without a value, such as the difference of two infinite times. A true
 * formula is untested if it depends on an implication whose premise never came true, or on signals
 * without values in the run.
 *
 * <p>The margin is that of the deciding comparison, in its own unit. In a formula of one dimension
 * it is the robustness of Signal Temporal Logic, the smallest (or largest) margin that decides.
 * Margins of several dimensions have no order, so in other formulas verdicts decide: the deciding
 * comparison is the first one, in time and then in the text, without which the verdict would
 * differ; of an implication that fails it is the conclusion. Margins are not normalized, since the
 * reported values would depend on an arbitrary scale for each unit.
 */
public final class Formula {

  private static final MathContext DIGITS = new MathContext(4);

  private final Condition condition;
  private final String text;

  private Formula(Condition condition, String text) {
    this.condition = condition;
    this.text = text;
  }

  /**
   * Reads a formula.
   *
   * @param duration of the scenario, in s
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) with the first problem: {@code
   *     scenario.formula.syntax}, {@code scenario.formula.unit}, {@code scenario.formula.signal}
   */
  public static Formula parse(SourceRange range, Signal.Source signals, double duration) {
    return parse(range, signals, duration, Optional.empty());
  }

  /**
   * Reads a formula as {@link #parse(SourceRange, Signal.Source, double)} does, and also rejects
   * one that is true or false in every run ({@code scenario.formula.constant}), or judged at a
   * single moment.
   *
   * @param ranges the values that signals can have
   */
  public static Formula parse(
      SourceRange range, Signal.Source signals, double duration, Range.Source ranges) {
    return parse(range, signals, duration, Optional.of(ranges));
  }

  /**
   * Reads a condition of a scenario that is true or false at each moment.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) as for {@link
   *     #parse(SourceRange, Signal.Source, double)}
   */
  public static Formula parseCircumstance(SourceRange range, Signal.Source signals) {
    Condition condition = FormulaParser.parseCircumstance(range, signals);
    return new Formula(condition, FormulaParser.plain(range.text()));
  }

  private static Formula parse(
      SourceRange range, Signal.Source signals, double duration, Optional<Range.Source> ranges) {
    Condition condition = FormulaParser.parse(range, signals, duration, ranges);
    return new Formula(condition, FormulaParser.plain(range.text()));
  }

  /** Returns a Boolean formula that a bench publishes, see {@link FormulaParser#parseMoment}. */
  public static Formula ofMoment(FormulaParser.Part part, String text) {
    Condition condition =
        part instanceof Term term ? Condition.Comparison.isTrue(term, text) : (Condition) part;
    return new Formula(condition, FormulaParser.plain(text));
  }

  /** Returns whether it is certainly true at the start of a run. */
  public boolean holds(SampledRun run) {
    return FormulaEvaluation.of(condition, run).verdict() > 0.0;
  }

  /** Returns whether it is certainly false at the start of a run. */
  public boolean isViolated(SampledRun run) {
    return FormulaEvaluation.of(condition, run).verdict() < 0.0;
  }

  /**
   * Returns the comparisons of a condition of one moment: it is true if all of one list hold.
   *
   * @return empty if there are more than 64 lists
   */
  public Optional<List<List<Inequality>>> alternatives() {
    return Inequality.alternatives(condition);
  }

  /** Returns the formula on one line. */
  public String text() {
    return text;
  }

  /** Returns all signals that it reads. */
  public Set<Signal> signals() {
    return condition
        .comparisons()
        .flatMap(Condition.Comparison::signals)
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  /**
   * Returns the end of the part of a run that the verdict needs, in ns: the reach of its intervals,
   * which without a bound is beyond every run.
   */
  public long horizon() {
    return condition.horizon(0) * World.TRACE_STEP;
  }

  /** Returns whether it only says what must always hold. */
  public boolean isLimit() {
    return isLimit(condition);
  }

  private static boolean isLimit(Condition condition) {
    if (condition instanceof Condition.Junction junction && junction.all()) {
      return isLimit(junction.first()) && isLimit(junction.second());
    }
    return condition instanceof Condition.Temporal temporal && temporal.always();
  }

  /** Returns whether what must always hold from a later time on held at each sample before it. */
  public boolean heldBefore(SampledRun run) {
    if (!(condition instanceof Condition.Temporal temporal)
        || !temporal.always()
        || temporal.interval().from() == 0) {
      return false;
    }
    Interval before = new Interval(0, temporal.interval().from(), true);
    Condition held = new Condition.Temporal(true, before, temporal.operand());
    return FormulaEvaluation.of(held, run).verdict() > 0.0;
  }

  /** Returns the parsed condition. */
  Condition condition() {
    return condition;
  }

  /** Returns the numbers that it compares single signals with. */
  public List<Limit> limits() {
    SampledRun none = new SampledRun(new Trace());
    return condition.comparisons().flatMap(each -> each.limit(none).stream()).distinct().toList();
  }

  public Outcome judge(Trace trace) {
    SampledRun run = new SampledRun(trace);
    FormulaEvaluation evaluation = FormulaEvaluation.of(condition, run);
    if (evaluation.verdict() == Robustness.UNKNOWN) {
      return unknown(evaluation, run);
    }
    if (evaluation.verdict() < 0.0) {
      return outcome(false, evaluation, run);
    }
    FormulaEvaluation strict = FormulaEvaluation.strictly(condition, run);
    return strict.verdict() > 0.0 ? outcome(true, strict, run) : unknown(strict, run);
  }

  /**
   * Returns whether a run that ended too early came to something that the formula asks for: to the
   * premise of one of its implications, with those that the conclusion has, or to a part without
   * any premise. Parts that are decided do not count.
   */
  public boolean cameToPremise(Trace trace) {
    return FormulaEvaluation.strictly(condition, new SampledRun(trace)).isOpen();
  }

  private static Outcome unknown(FormulaEvaluation evaluation, SampledRun run) {
    FormulaEvaluation.Decision decision = evaluation.decision();
    if (decision.vacuity().isPresent()) {
      return Outcome.untested(decision.vacuity().get());
    }
    return decision
        .comparison()
        .map(it -> valueless(it, run, decision.sample()))
        .orElseGet(
            () ->
                Outcome.undecided(
                    String.format(
                        Locale.ROOT,
                        "the run ended %s%s, before it was decided",
                        after(run, run.size() - 1),
                        byAnImpact(run.trace()))));
  }

  private static String byAnImpact(Trace trace) {
    return trace.impact().isEmpty() ? "" : " by an impact (" + trace.impact() + ")";
  }

  private static Outcome valueless(Condition.Comparison comparison, SampledRun run, int sample) {
    String text =
        String.format(Locale.ROOT, "'%s' has no value %s", comparison.text(), after(run, sample));
    List<Signal> silent =
        comparison
            .signals()
            .flatMap(Signal::origins)
            .filter(signal -> signal.topic().isPresent() && Double.isNaN(run.of(signal)[sample]))
            .toList();
    if (silent.isEmpty()) {
      return Outcome.untested(text);
    }
    List<String> topics =
        silent.stream().flatMap(each -> each.topic().stream()).distinct().toList();
    return Outcome.valueless(
        text
            + ", since there was no current message on "
            + topics.get(0)
            + first(run.of(silent.get(0)), sample, run),
        topics);
  }

  /** Returns when the first message came, for a formula that begins before it; or nothing. */
  private static String first(double[] values, int sample, SampledRun run) {
    int first = 0;
    while (first < values.length && Double.isNaN(values[first])) {
      first++;
    }
    return first > sample && first < values.length
        ? "; the first one came " + after(run, first)
        : "";
  }

  private static Outcome outcome(boolean passed, FormulaEvaluation evaluation, SampledRun run) {
    FormulaEvaluation.Decision decision = evaluation.decision();
    if (decision.comparison().isEmpty()) {
      return new Outcome(passed, "nothing comes before the start");
    }
    return outcome(passed, decision, decision.comparison().get(), run)
        .withOtherwise(decision.otherwise().stream().map(run::seconds).toList());
  }

  private static Outcome outcome(
      boolean passed,
      FormulaEvaluation.Decision decision,
      Condition.Comparison comparison,
      SampledRun run) {
    boolean holds = decision.truth() > 0.0;
    if (comparison.ofTruth()) {
      String when = after(run, decision.sample());
      return new Outcome(
          passed,
          String.format(
              Locale.ROOT,
              "'%s' %s %s",
              comparison.text(),
              holds ? "holds" : passed ? "is false" : "is missed",
              when + comparison.named().map(it -> it.found(run, decision.sample())).orElse("")),
          run.seconds(decision.sample()));
    }
    String unit = comparison.left().commonUnit(comparison.right());
    double margin = Robustness.margin(decision.truth());
    String text =
        String.format(
            Locale.ROOT,
            "'%s' %s %s %s",
            comparison.text(),
            holds ? "holds by" : passed ? "is false by" : "is missed by",
            number(margin, unit),
            after(run, decision.sample()));
    double signed = inUnit(passed ? margin : -margin, unit);
    return new Outcome(passed, text, new Margin(signed, unit, run.seconds(decision.sample())));
  }

  private static String after(SampledRun run, int sample) {
    return String.format(Locale.ROOT, "after %.2f s", run.seconds(sample));
  }

  private static double inUnit(double margin, String unit) {
    if (unit.isEmpty()) {
      return margin;
    }
    Unit shown = Unit.parse(unit).orElseThrow();
    return margin / (shown.coherent(1.0) - shown.coherent(0.0));
  }

  private static String number(double margin, String unit) {
    if (Double.isInfinite(margin)) {
      return "infinity";
    }
    String digits =
        new BigDecimal(inUnit(margin, unit)).round(DIGITS).stripTrailingZeros().toPlainString();
    String name = unit.isEmpty() ? " (in SI units)" : unit.equals("1") ? "" : " " + unit;
    return digits + name;
  }
}

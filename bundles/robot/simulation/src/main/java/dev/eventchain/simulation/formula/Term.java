package dev.eventchain.simulation.formula;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntToDoubleFunction;

/**
 * An expression with a value at each sample.
 *
 * @param dimension its unit; only the dimension matters, since the values are coherent
 * @param unit the unit for output, as written; empty if there is no such unit
 * @param truth true if it is a single Boolean signal
 * @param signals the signals that it depends on
 * @param values its values in coherent units
 * @param sum its value as a sum
 */
public record Term(
    Unit dimension, String unit, boolean truth, Set<Signal> signals, Values values, Sum sum)
    implements FormulaParser.Part {

  /** Provides the values in a run. */
  public interface Values {
    IntToDoubleFunction in(SampledRun run);
  }

  /**
   * Reads a quantity of one moment.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) as for {@link
   *     Formula#parseCircumstance}
   */
  public static Term parseCircumstance(SourceRange range, Signal.Source signals) {
    return FormulaParser.parseQuantity(range, signals);
  }

  static Term number(double number, Unit unit, String text) {
    double value = unit.coherent(number);
    return new Term(unit, text, false, Set.of(), run -> sample -> value, Sum.number(value));
  }

  static Term of(Signal signal) {
    return new Term(
        signal.dimension(),
        signal.unit(),
        signal.truth(),
        Set.of(signal),
        new Reading(signal),
        Sum.of(signal.name(), signal.range()::apply));
  }

  /** Values of a single signal, unchanged. */
  private record Reading(Signal signal) implements Values {

    @Override
    public IntToDoubleFunction in(SampledRun run) {
      double[] samples = run.of(signal);
      return sample -> samples[sample];
    }
  }

  /** Returns the limit of a plain signal, if this is one and the other term depends on none. */
  Optional<ScenarioVerdict.Limit> limit(Term other, SampledRun run) {
    return values instanceof Reading reading && other.signals.isEmpty()
        ? Optional.of(
            new ScenarioVerdict.Limit(
                reading.signal().name(),
                reading.signal().inUnit(other.values.in(run).applyAsDouble(0))))
        : Optional.empty();
  }

  /** Returns the range of all its values. */
  public Range range(Range.Source ranges) {
    return sum.range(ranges);
  }

  Term negative() {
    return mapped(value -> 0.0 - value, Sum.number(0.0).plus(sum, -1.0));
  }

  Term absolute() {
    return mapped(Math::abs, Sum.of(new Object(), ranges -> range(ranges).absolute()));
  }

  /** Returns the next whole number that is not smaller; of a plain number only. */
  Term ceiling() {
    return mapped(Math::ceil, Sum.of(new Object(), ranges -> range(ranges).ceiling()));
  }

  private Term mapped(DoubleUnaryOperator operator, Sum result) {
    return new Term(
        dimension,
        unit,
        false,
        signals,
        run -> {
          IntToDoubleFunction inner = values.in(run);
          return sample -> operator.applyAsDouble(inner.applyAsDouble(sample));
        },
        result);
  }

  /** Returns the sum with a term of the same dimension. */
  Term plus(Term other) {
    return combined(other, dimension, commonUnit(other), Double::sum, sum.plus(other.sum, 1.0));
  }

  /** Returns the difference from a term of the same dimension. */
  Term minus(Term other) {
    return combined(
        other, dimension, commonUnit(other), (a, b) -> a - b, sum.plus(other.sum, -1.0));
  }

  /** Returns the larger or the smaller of two terms of one dimension. */
  Term extreme(Term other, boolean larger) {
    Range.Of range =
        ranges ->
            larger
                ? range(ranges).maximum(other.range(ranges))
                : range(ranges).minimum(other.range(ranges));
    return combined(
        other,
        dimension,
        commonUnit(other),
        larger ? Math::max : Math::min,
        Sum.of(new Object(), range));
  }

  /**
   * Returns the change per second over a window, which ends at each sample. Before the start, the
   * value is taken to have been as at the start.
   *
   * @param window in samples, at least 1
   */
  Term derivative(int window) {
    double seconds = World.seconds(window * World.TRACE_STEP);
    Range.Of range =
        ranges -> {
          Range all = range(ranges);
          return all.plus(all.times(NEGATIVE)).times(new Range(1.0 / seconds, 1.0 / seconds));
        };
    return new Term(
        dimension.times(Unit.parse("s").orElseThrow(), -1),
        perSecond(unit),
        false,
        signals,
        run -> {
          IntToDoubleFunction inner = values.in(run);
          return sample ->
              (inner.applyAsDouble(sample) - inner.applyAsDouble(Math.max(0, sample - window)))
                  / seconds;
        },
        Sum.of(new Object(), range));
  }

  private static final Range NEGATIVE = new Range(-1.0, -1.0);

  /** Returns the name of a unit per second, if that has one. */
  private static String perSecond(String unit) {
    String name =
        unit.endsWith("/s")
            ? unit + "2"
            : unit.endsWith("/s2") ? unit.replace("/s2", "/s3") : unit + "/s";
    return Unit.parse(name).isPresent() ? name : "";
  }

  /** Returns this where a condition of one moment is true, and another term where it is false. */
  Term where(Condition condition, Term other) {
    Range.Of range = ranges -> range(ranges).union(other.range(ranges));
    Term either =
        combined(other, dimension, commonUnit(other), Double::sum, Sum.of(new Object(), range));
    Set<Signal> all = new LinkedHashSet<>(either.signals);
    condition.comparisons().flatMap(Condition.Comparison::signals).forEach(all::add);
    return new Term(
        dimension,
        either.unit,
        false,
        all,
        run -> {
          double[] truth = FormulaEvaluation.truth(condition, run);
          IntToDoubleFunction first = values.in(run);
          IntToDoubleFunction second = other.values.in(run);
          return sample ->
              truth[sample] == Robustness.UNKNOWN
                  ? Double.NaN
                  : (truth[sample] > 0.0 ? first : second).applyAsDouble(sample);
        },
        either.sum);
  }

  /** Returns the product, or with power -1 the quotient. */
  Term times(Term other, int power) {
    String name = other.isPlain() ? unit : isPlain() && power == 1 ? other.unit : "";
    return combined(
        other,
        dimension.times(other.dimension, power),
        name,
        power == 1 ? (a, b) -> a * b : (a, b) -> a / b,
        power == 1 ? product(other) : quotient(other));
  }

  private Sum product(Term other) {
    if (other.sum.isNumber()) {
      return Sum.number(0.0).plus(sum, other.sum.number());
    }
    return sum.isNumber()
        ? Sum.number(0.0).plus(other.sum, sum.number())
        : Sum.of(new Object(), ranges -> range(ranges).times(other.range(ranges)));
  }

  private Sum quotient(Term other) {
    return other.sum.isNumber() && other.sum.number() != 0.0
        ? Sum.number(0.0).plus(sum, 1.0 / other.sum.number())
        : Sum.of(new Object(), ranges -> range(ranges).by(other.range(ranges)));
  }

  private Term combined(
      Term other, Unit newDimension, String name, DoubleBinaryOperator operator, Sum result) {
    Set<Signal> all = new LinkedHashSet<>(signals);
    all.addAll(other.signals);
    return new Term(
        newDimension,
        name,
        false,
        all,
        run -> {
          IntToDoubleFunction first = values.in(run);
          IntToDoubleFunction second = other.values.in(run);
          return sample ->
              operator.applyAsDouble(first.applyAsDouble(sample), second.applyAsDouble(sample));
        },
        result);
  }

  /**
   * Returns the unit for output of the two terms: that of a number takes precedence over a
   * signal's.
   */
  String commonUnit(Term other) {
    List<Term> numbersFirst = signals.isEmpty() ? List.of(this, other) : List.of(other, this);
    return numbersFirst.stream()
        .map(Term::unit)
        .filter(name -> !name.isEmpty())
        .findFirst()
        .orElse("");
  }

  boolean comparesWith(Term other) {
    Unit.Relation relation = dimension.relationTo(other.dimension);
    return relation == Unit.Relation.SAME || relation == Unit.Relation.CONVERTIBLE;
  }

  boolean isPlain() {
    return isWithoutUnit() || unit.equals("%");
  }

  /** Returns whether it is a plain number, and no percentage. */
  boolean isWithoutUnit() {
    return dimension.relationTo(Unit.parse("1").orElseThrow()) == Unit.Relation.SAME
        && !unit.equals("%");
  }

  /** Returns why it has no values in a trace; empty if it has some. */
  public Optional<String> absence(Trace trace) {
    return signals.stream().flatMap(signal -> signal.absence().apply(trace).stream()).findFirst();
  }
}

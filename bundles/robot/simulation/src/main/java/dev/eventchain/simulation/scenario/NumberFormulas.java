package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.Term;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.Trace;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;

/**
 * Formulas of one moment over named numbers without units: conditions such as {@code gap > speed /
 * 2}, and quantities such as {@code gap + 2 * speed}. Immutable.
 */
public final class NumberFormulas {

  /**
   * A quantity.
   *
   * @param names those of the numbers that it reads
   * @param value its value, given the numbers by their names; not finite where there is none
   */
  public record Quantity(Set<String> names, ToDoubleFunction<Map<String, Double>> value) {}

  /**
   * A condition.
   *
   * @param names those of the numbers that it reads
   * @param holds whether it is true, given the numbers by their names
   */
  public record Condition(Set<String> names, Predicate<Map<String, Double>> holds) {}

  private final Numbers numbers;

  /** Creates formulas over the numbers of these names. */
  public NumberFormulas(Collection<String> names) {
    numbers = new Numbers(names);
  }

  /**
   * Reads a condition on numbers that are given by their names.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) with what is wrong with it, as
   *     for a formula of a scenario
   */
  public Condition condition(SourceRange text) {
    Formula formula = Formula.parseCircumstance(text, numbers);
    return new Condition(names(formula.signals()), values -> formula.holds(moment(values)));
  }

  /**
   * Reads a quantity.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) as for a condition
   */
  public Quantity quantity(SourceRange text) {
    Term term = Term.parseCircumstance(text, numbers);
    return new Quantity(
        names(term.signals()), values -> term.values().in(moment(values)).applyAsDouble(0));
  }

  private static Set<String> names(Collection<Signal> signals) {
    return signals.stream().map(Signal::name).collect(Collectors.toUnmodifiableSet());
  }

  private static SampledRun moment(Map<String, Double> values) {
    Map<String, Script> scripts = new LinkedHashMap<>();
    values.forEach((name, value) -> scripts.put(name, constant(value)));
    Trace trace = new Trace(scripts, Road.straight());
    trace.state(new Trace.State(0, 0, 0, 0, 0, 0, Double.NaN, Trace.Pose.STRAIGHT));
    return new SampledRun(trace);
  }

  private static Script constant(double value) {
    return new Script(List.of(new Script.Step(0, value)));
  }

  private static final class Numbers implements Signal.Source {

    private final Map<String, Signal> signals = new LinkedHashMap<>();

    Numbers(Collection<String> names) {
      for (String name : names) {
        signals.put(
            name,
            new Signal(
                name,
                "1",
                false,
                name,
                trace -> new double[] {trace.input(name).orElseThrow().at(0)},
                trace -> Optional.empty()));
      }
    }

    @Override
    public Optional<Signal> find(String name) {
      return Optional.ofNullable(signals.get(name));
    }

    @Override
    public boolean readsOutputs() {
      return false;
    }

    @Override
    public Collection<String> names() {
      return signals.keySet();
    }
  }
}

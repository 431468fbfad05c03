package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.world.Trace;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Conditions over named numbers: formulas of one moment without units, such as {@code gap > speed /
 * 2}. Not thread-safe.
 */
public final class NumberConditions {

  private static final Trace MOMENT = new Trace();

  static {
    MOMENT.state(new Trace.State(0, 0, 0, 0, 0, 0, Double.NaN, Trace.Pose.STRAIGHT));
  }

  private final List<Formula> formulas = new ArrayList<>();
  private final Numbers numbers;
  private double[] values = {};

  /** Creates conditions over the numbers of these names. */
  public NumberConditions(List<String> names) {
    numbers = new Numbers(names);
  }

  /**
   * Adds a condition.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) with what is wrong with it, as
   *     for a formula of a scenario
   */
  public void add(SourceRange condition) {
    formulas.add(Formula.parseCircumstance(condition, numbers));
  }

  /** Returns whether all are true of values, in the order of the names. */
  public boolean hold(double[] current) {
    values = current.clone();
    return formulas.stream().allMatch(formula -> formula.holds(new SampledRun(MOMENT)));
  }

  private final class Numbers implements Signal.Source {

    private final Map<String, Signal> signals = new LinkedHashMap<>();

    Numbers(List<String> names) {
      for (int i = 0; i < names.size(); i++) {
        int index = i;
        signals.put(
            names.get(i),
            new Signal(
                names.get(i),
                "1",
                false,
                names.get(i),
                trace -> new double[] {values[index]},
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

package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.Trace;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The conditions that keep combinations of factors: formulas without units over their names, such
 * as {@code gap > speed / 2}.
 */
final class Conditions {

  private final CampaignPlan plan;
  private final List<Formula> formulas = new ArrayList<>();
  private final double[] values;

  /**
   * Reads the conditions of a campaign.
   *
   * @throws DiagnosticException (INPUT) if one cannot be read
   */
  Conditions(CampaignPlan plan) {
    this.plan = plan;
    this.values = new double[plan.factors().size()];
    for (SourceRange condition : plan.conditions()) {
      try {
        formulas.add(Formula.parseCircumstance(condition, new Factors()));
      } catch (DiagnosticException e) {
        Diagnostic first = e.diagnostics().get(0);
        throw new DiagnosticException(
            DiagnosticException.Reason.INPUT,
            Diagnostic.of(
                    CampaignRules.CONDITION,
                    "'" + condition.text().strip() + "': " + first.message(),
                    SourceLocation.of(plan.file()))
                .withHint(first.hint()));
      }
    }
  }

  /** Returns whether all are true of a case. */
  boolean keep(CampaignCase each) {
    if (formulas.isEmpty()) {
      return true;
    }
    for (int i = 0; i < values.length; i++) {
      values[i] = each.values().get(i).doubleValue();
    }
    Trace moment = new Trace(Map.<String, Script>of(), Road.STRAIGHT);
    moment.state(new Trace.State(0, 0, 0, 0, 0, 0, Double.NaN, Trace.Pose.STRAIGHT));
    return formulas.stream().allMatch(formula -> formula.holds(new SampledRun(moment)));
  }

  /** The factors of the case that is looked at. */
  private final class Factors implements Signal.Source {

    private final Map<String, Signal> signals =
        plan.names().stream().distinct().collect(Collectors.toMap(name -> name, this::signal));

    private Signal signal(String name) {
      int index = plan.names().indexOf(name);
      return new Signal(
          name, "1", false, name, trace -> new double[] {values[index]}, trace -> Optional.empty());
    }

    @Override
    public Optional<Signal> find(String name) {
      return Optional.ofNullable(signals.get(name));
    }

    @Override
    public Collection<String> names() {
      return plan.names();
    }
  }
}

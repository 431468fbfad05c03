package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.simulation.scenario.NumberFormulas;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/** The conditions that keep combinations of the factors' values. */
public final class Conditions {

  private final CampaignPlan plan;
  private final List<Predicate<Map<String, Double>>> conditions = new ArrayList<>();

  /**
   * Reads the conditions of a campaign.
   *
   * @throws DiagnosticException (INPUT) if one cannot be read
   */
  public Conditions(CampaignPlan plan) {
    this.plan = plan;
    NumberFormulas formulas = new NumberFormulas(plan.names());
    for (SourceRange condition : plan.conditions()) {
      try {
        conditions.add(formulas.condition(condition));
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
  public boolean keep(CampaignCase each) {
    return conditions.isEmpty() || conditions.stream().allMatch(it -> it.test(plan.numbers(each)));
  }
}

package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.simulation.scenario.NumberConditions;
import java.math.BigDecimal;

/** The conditions that keep combinations of the factors' values. */
final class Conditions {

  private final NumberConditions conditions;

  /**
   * Reads the conditions of a campaign.
   *
   * @throws DiagnosticException (INPUT) if one cannot be read
   */
  Conditions(CampaignPlan plan) {
    conditions = new NumberConditions(plan.names());
    for (SourceRange condition : plan.conditions()) {
      try {
        conditions.add(condition);
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
    return conditions.hold(each.values().stream().mapToDouble(BigDecimal::doubleValue).toArray());
  }
}

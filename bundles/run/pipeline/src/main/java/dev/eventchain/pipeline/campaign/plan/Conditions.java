package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.simulation.scenario.NumberFormulas;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Conditions on cases, over the values of the factors and what is computed from them. */
public final class Conditions {

  private final CampaignPlan plan;
  private final List<NumberFormulas.Condition> ofFactors = new ArrayList<>();
  private final List<NumberFormulas.Condition> ofComputed = new ArrayList<>();

  /**
   * Reads conditions of a campaign.
   *
   * @throws DiagnosticException (INPUT) if one cannot be read
   */
  public Conditions(CampaignPlan plan, List<SourceRange> texts) {
    this.plan = plan;
    NumberFormulas formulas = new NumberFormulas(plan.allNames());
    Set<String> factors = Set.copyOf(plan.names());
    for (SourceRange condition : texts) {
      try {
        NumberFormulas.Condition read = formulas.condition(condition);
        (factors.containsAll(read.names()) ? ofFactors : ofComputed).add(read);
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

  /**
   * Returns whether all are true of a case. What is computed may have no value where a condition on
   * the factors is false, and is not computed there.
   *
   * @throws DiagnosticException (INPUT) if something that is computed has no value
   */
  public boolean keep(CampaignCase each) {
    return all(ofFactors, plan.numbers(each))
        && (ofComputed.isEmpty() || all(ofComputed, plan.allNumbers(each)));
  }

  private static boolean all(
      List<NumberFormulas.Condition> conditions, Map<String, Double> numbers) {
    return conditions.stream().allMatch(it -> it.holds().test(numbers));
  }
}

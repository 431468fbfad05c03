package dev.eventchain.pipeline.simulate;

import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.RequirementOutcome.Outcome;
import dev.eventchain.project.AcceptedTexts;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** Outcomes of requirements, from the scenarios and from the constraints that implement them. */
public final class RequirementOutcomes {

  private RequirementOutcomes() {}

  /**
   * Returns the identifier and the outcome of each requirement, in their order.
   *
   * @param unproven requirements that no criterion can prove, see {@link
   *     RequirementCoverage#unproven}
   * @param evidence the evidence from their constraints on the measured model
   * @param strength the strength of the evidence from their scenarios
   */
  static List<RequirementOutcome> of(
      List<WrittenRequirement> requirements,
      List<ScenarioVerdict> verdicts,
      Set<String> unproven,
      RuleEvidence evidence,
      RequirementStrength strength) {
    List<RequirementOutcome> outcomes = new ArrayList<>();
    for (WrittenRequirement item : requirements) {
      List<CriterionResult> about =
          verdicts.stream().flatMap(each -> each.criteriaOf(item.id())).toList();
      boolean untested =
          unproven.contains(item.id())
              || evidence.untestedIds().contains(item.id())
              || strength.isUntested(item.id());
      Outcome outcome =
          evidence.violatedIds().contains(item.id()) ? Outcome.VIOLATED : outcome(about, untested);
      outcomes.add(
          new RequirementOutcome(
              item.id(), outcome, AcceptedTexts.fingerprint(item.text()), strength.of(item.id())));
    }
    return outcomes;
  }

  private static Outcome outcome(List<CriterionResult> criteria, boolean untested) {
    if (criteria.stream().anyMatch(each -> each.tested() && !each.passed())) {
      return Outcome.VIOLATED;
    }
    boolean proved = !criteria.isEmpty() && criteria.stream().allMatch(CriterionResult::passed);
    return proved && !untested ? Outcome.PROVED : Outcome.NOT_TESTED;
  }

  /** Returns the identifiers of untested requirements. */
  static Set<String> untested(List<RequirementOutcome> outcomes) {
    return outcomes.stream()
        .filter(each -> each.outcome() == Outcome.NOT_TESTED)
        .map(RequirementOutcome::id)
        .collect(Collectors.toSet());
  }

  /**
   * Returns the number of requirements by outcome: "5 requirements proved, 1 violated"; empty if
   * there are none.
   *
   * @param outcomes the outcomes from {@link #of}
   */
  public static String counted(List<RequirementOutcome> outcomes) {
    List<String> counts = new ArrayList<>();
    for (Outcome outcome : Outcome.values()) {
      long count = outcomes.stream().filter(each -> each.outcome() == outcome).count();
      if (count > 0) {
        String noun = !counts.isEmpty() ? "" : count == 1 ? "requirement " : "requirements ";
        counts.add(count + " " + noun + outcome.words());
      }
    }
    return String.join(", ", counts);
  }
}

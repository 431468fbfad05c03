package dev.eventchain.pipeline.simulate;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/** Outcomes of requirements, from the scenarios and from the constraints that implement them. */
public final class RequirementOutcomes {

  private enum Outcome {
    /** At least one scenario names it and all of them passed; so did its constraints, if any. */
    PROVED,
    /** A scenario that names it failed, or one of its constraints is violated. */
    VIOLATED,
    /** No scenario names it, or a scenario or constraint that names it could not be judged. */
    NOT_TESTED;

    String words() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  private RequirementOutcomes() {}

  /**
   * Returns the identifier and the outcome of each requirement, in their order.
   *
   * @param unproven requirements that no criterion can prove, see {@link
   *     RequirementCoverage#unproven}
   * @param evidence the evidence from their constraints on the measured model
   */
  static ArrayNode of(
      List<WrittenRequirement> requirements,
      List<ScenarioVerdict> verdicts,
      Set<String> unproven,
      RuleEvidence evidence) {
    ArrayNode outcomes = JsonNodeFactory.instance.arrayNode();
    for (WrittenRequirement item : requirements) {
      List<ScenarioVerdict> about =
          verdicts.stream().filter(each -> each.requirements().contains(item.id())).toList();
      boolean untested = unproven.contains(item.id()) || evidence.untestedIds().contains(item.id());
      Outcome outcome =
          evidence.violatedIds().contains(item.id()) ? Outcome.VIOLATED : outcome(about, untested);
      outcomes.addObject().put("id", item.id()).put("outcome", outcome.words());
    }
    return outcomes;
  }

  private static Outcome outcome(List<ScenarioVerdict> verdicts, boolean untested) {
    if (verdicts.stream().anyMatch(each -> each.tested() && !each.passed())) {
      return Outcome.VIOLATED;
    }
    boolean proved = !verdicts.isEmpty() && verdicts.stream().allMatch(ScenarioVerdict::passed);
    return proved && !untested ? Outcome.PROVED : Outcome.NOT_TESTED;
  }

  /** Returns the identifiers of untested requirements. */
  static Set<String> untested(JsonNode outcomes) {
    Set<String> ids = new TreeSet<>();
    outcomes.forEach(
        each -> {
          if (each.path("outcome").asText().equals(Outcome.NOT_TESTED.words())) {
            ids.add(each.path("id").asText());
          }
        });
    return ids;
  }

  /**
   * Returns the number of requirements by outcome: "5 requirements proved, 1 violated"; empty if
   * there are none.
   *
   * @param outcomes the outcomes from {@link #of}
   */
  public static String counted(JsonNode outcomes) {
    List<String> counts = new ArrayList<>();
    for (Outcome outcome : Outcome.values()) {
      int count = 0;
      for (JsonNode each : outcomes) {
        count += each.path("outcome").asText().equals(outcome.words()) ? 1 : 0;
      }
      if (count > 0) {
        String noun = !counts.isEmpty() ? "" : count == 1 ? "requirement " : "requirements ";
        counts.add(count + " " + noun + outcome.words());
      }
    }
    return String.join(", ", counts);
  }
}

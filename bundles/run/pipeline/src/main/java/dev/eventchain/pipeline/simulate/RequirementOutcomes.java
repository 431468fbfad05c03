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

/** What the scenarios, and the constraints that stand for a requirement, say of it. */
public final class RequirementOutcomes {

  private enum Outcome {
    /** Each scenario that names it passed, and there is one; so do its constraints, if any. */
    PROVED,
    /** A scenario that names it failed, or a constraint that stands for it is violated. */
    VIOLATED,
    /** No scenario names it, or a scenario or constraint that does could not be judged. */
    NOT_TESTED;

    String words() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  private RequirementOutcomes() {}

  /**
   * The id and the outcome of each requirement, in their order.
   *
   * @param unproven ids of those that no criterion can prove, see {@link
   *     RequirementCoverage#unproven}
   * @param evidence what the measured model says of their constraints
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

  /** The ids of those that are not tested. */
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
   * How many there are of each kind: "5 requirements proved, 1 violated"; empty if there are none.
   *
   * @param outcomes as {@link #of} makes them
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

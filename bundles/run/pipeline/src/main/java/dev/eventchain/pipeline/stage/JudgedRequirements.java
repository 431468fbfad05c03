package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.JudgedWords;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Comparison of what criteria judge with what the requirements say. A criterion that judges more
 * fails software that is correct.
 */
final class JudgedRequirements {

  private JudgedRequirements() {}

  /**
   * Compares the words that criteria quote with the requirements.
   *
   * @return {@code scenario.judges.words} for words that a requirement does not have; {@code
   *     scenario.judges.missing} for criteria without words, if any criterion has some
   */
  static List<Diagnostic> check(List<Scenario> scenarios, List<WrittenRequirement> requirements) {
    Map<String, String> texts =
        requirements.stream()
            .collect(
                Collectors.toMap(WrittenRequirement::id, WrittenRequirement::text, (a, b) -> a));
    List<Diagnostic> found = new ArrayList<>();
    boolean quotes = scenarios.stream().anyMatch(each -> !each.judged().isEmpty());
    for (Scenario scenario : scenarios) {
      scenario.judged().stream()
          .filter(each -> texts.containsKey(each.requirement()))
          .filter(each -> !each.areIn(texts.get(each.requirement())))
          .map(each -> unsaid(each, texts.get(each.requirement())))
          .forEach(found::add);
      if (quotes) {
        withoutWords(scenario).forEach(found::add);
      }
    }
    return found;
  }

  private static Diagnostic unsaid(JudgedWords words, String text) {
    return Diagnostic.of(
            StageRules.SCENARIO_JUDGES_WORDS,
            "%s does not say \"%s\".".formatted(words.requirement(), words.words()),
            words.location())
        .withHint("It says: " + text);
  }

  private static List<Diagnostic> withoutWords(Scenario scenario) {
    Set<SourceLocation> quoting =
        scenario.judged().stream().map(JudgedWords::criterion).collect(Collectors.toSet());
    return scenario.criteria().stream()
        .filter(each -> !each.isOfEveryScenario() && !quoting.contains(each.location()))
        .map(JudgedRequirements::missing)
        .toList();
  }

  private static Diagnostic missing(Expectation criterion) {
    return Diagnostic.of(
            StageRules.SCENARIO_JUDGES_MISSING,
            "It does not say which words of a requirement it judges: " + criterion.text(),
            criterion.location())
        .withHint("Quote them under 'judges', or move the formula to 'observe'.");
  }
}

package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.JudgedWords;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Numbers with a unit in the texts of requirements that no criterion quotes. A requirement may be
 * proved by criteria on its other words, and nothing would notice another number.
 */
final class UnjudgedNumbers {

  private static final Pattern SPACE = Pattern.compile("\\s+");
  private static final String FACTOR = "[\\p{L}\u00b0%]+(?:\\^?\\d|[\u00b2\u00b3])?";

  /** A number with a word that may be its unit; not in ids, dates, times and versions. */
  private static final Pattern NUMBER =
      Pattern.compile(
          "(?:(?<![\\p{L}\\d_.,:-])|(?<=\\d-))[-+\u2212]?\\d+(?:[.,]\\d+)?"
              + "\\**[\\s\u00a0\u202f]*(%s(?:[/\u00b7*]%s)*)".formatted(FACTOR, FACTOR));

  /** Words that are far more often something else, as in "1 in 3", "2d" and "ISO 15622 B". */
  private static final Set<String> NO_UNITS = Set.of("in", "d", "B");

  private final List<Scenario> scenarios;

  private UnjudgedNumbers(List<Scenario> scenarios) {
    this.scenarios = scenarios;
  }

  /**
   * Returns a finding for each requirement with such numbers, if criteria quote it. One that a
   * criterion tests without quoting it is taken to be judged as a whole.
   *
   * @param scenarios all scenarios of a project
   */
  static List<Diagnostic> check(List<Scenario> scenarios, List<WrittenRequirement> requirements) {
    UnjudgedNumbers numbers = new UnjudgedNumbers(scenarios);
    return requirements.stream().flatMap(each -> numbers.of(each).stream()).toList();
  }

  private Optional<Diagnostic> of(WrittenRequirement requirement) {
    List<JudgedWords> quotes =
        scenarios.stream()
            .flatMap(each -> each.judged().stream())
            .filter(each -> each.requirement().equals(requirement.id()))
            .toList();
    if (quotes.isEmpty() || isJudgedAsAWhole(requirement.id(), quotes)) {
      return Optional.empty();
    }
    List<String> unjudged = unjudged(plain(requirement.text()), quotes);
    return unjudged.isEmpty()
        ? Optional.empty()
        : Optional.of(finding(requirement, String.join(", ", unjudged)));
  }

  private boolean isJudgedAsAWhole(String requirement, List<JudgedWords> quotes) {
    return scenarios.stream()
        .flatMap(each -> each.criteria().stream())
        .filter(each -> !each.isOfEveryScenario() && each.requirements().contains(requirement))
        .anyMatch(each -> quotes.stream().noneMatch(quote -> isOf(quote, each)));
  }

  private static boolean isOf(JudgedWords quote, Expectation criterion) {
    return quote.criterion().equals(criterion.location());
  }

  private static List<String> unjudged(String text, List<JudgedWords> quotes) {
    BitSet quoted = new BitSet(text.length());
    for (JudgedWords quote : quotes) {
      String words = plain(quote.words());
      for (int at = text.indexOf(words); at >= 0; at = text.indexOf(words, at + 1)) {
        quoted.set(at, at + words.length());
      }
    }
    List<String> found = new ArrayList<>();
    Matcher number = NUMBER.matcher(text);
    while (number.find()) {
      if (isUnit(number.group(1)) && quoted.nextClearBit(number.start()) < number.end()) {
        found.add("'" + number.group() + "'");
      }
    }
    return found.stream().distinct().toList();
  }

  private static boolean isUnit(String word) {
    return !NO_UNITS.contains(word) && Unit.parse(word).isPresent();
  }

  private static String plain(String text) {
    return SPACE.matcher(text.strip()).replaceAll(" ");
  }

  private static Diagnostic finding(WrittenRequirement requirement, String numbers) {
    return Diagnostic.of(
            StageRules.SCENARIO_JUDGES_NUMBER,
            "No criterion of a scenario judges %s of %s.".formatted(numbers, requirement.id()),
            requirement.location())
        .withHint(
            "Quote the words with the number under 'judges' of a criterion that fails with another"
                + " number, or add such a criterion.");
  }
}

package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.pipeline.campaign.plan.SearchSettings;
import java.util.List;
import java.util.Optional;

/** A criterion of a scenario that a campaign file names by the beginning of its text. */
final class NamedCriterion {

  private NamedCriterion() {}

  /**
   * Returns a finding unless it is one of some case, and no case has two of that beginning.
   *
   * @param rule that of the finding
   * @param scenario its name
   * @param texts those of the criteria of each kind of cases
   */
  static Optional<Diagnostic> problem(
      Rule rule, SearchSettings.Named named, String scenario, List<List<String>> texts) {
    long meant = texts.stream().mapToLong(it -> count(it, named.text())).max().orElse(0);
    if (meant == 1) {
      return Optional.empty();
    }
    String words = meant == 0 ? "No criterion of '%s' begins" : "Several criteria of '%s' begin";
    List<String> all = texts.stream().flatMap(List::stream).distinct().toList();
    return Optional.of(
        Diagnostic.of(
                rule, words.formatted(scenario) + " with '" + named.text() + "'.", named.place())
            .withHint(NearestName.hint(named.text(), all)));
  }

  private static long count(List<String> texts, String beginning) {
    return texts.stream().filter(text -> text.startsWith(beginning)).count();
  }
}

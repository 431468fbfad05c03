package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.pipeline.search.SearchMethod;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Statements of a campaign file about a search.
 *
 * @param criterion the one whose margin is minimised; without it, another one by each seed
 * @param runs how many cases are simulated until it ends, without those that make finds simpler
 * @param seeds the number of independent searches
 * @param stopsAtFirst whether it ends with the first failed case
 */
public record SearchSettings(
    Optional<Named> criterion, SearchMethod method, int runs, int seeds, boolean stopsAtFirst) {

  private static final NumberRange RUNS = NumberRange.of(10, 100_000);
  private static final NumberRange SEEDS = NumberRange.of(1, 64);
  private static final String FIRST_FAILURE = "first_failure";

  public static final SearchSettings USUAL =
      new SearchSettings(Optional.empty(), SearchMethod.CMA_ES, 200, 2, false);

  /** A text, and where it is. */
  public record Named(String text, SourceLocation place) {}

  public static SearchSettings read(ObjectReader part) {
    Optional<Named> criterion = criterion(part);
    List<String> methods = Arrays.stream(SearchMethod.values()).map(SearchMethod::key).toList();
    String method = oneOf(part, "method", methods, USUAL.method.key());
    int runs = (int) part.wholeNumber("runs", RUNS).orElse(USUAL.runs);
    int seeds = (int) part.wholeNumber("seeds", SEEDS).orElse(USUAL.seeds);
    String stop = oneOf(part, "stop", List.of(FIRST_FAILURE, "never"), "never");
    part.refuseOthers();
    return new SearchSettings(
        criterion,
        SearchMethod.valueOf(method.toUpperCase(Locale.ROOT)),
        runs,
        seeds,
        stop.equals(FIRST_FAILURE));
  }

  /** Reads the beginning of the text of a criterion. */
  static Optional<Named> criterion(ObjectReader part) {
    return part.text("criterion").map(text -> new Named(text, part.at("criterion")));
  }

  private static String oneOf(ObjectReader part, String key, List<String> known, String usual) {
    String text = part.text(key).orElse(usual);
    if (known.contains(text)) {
      return text;
    }
    String message = "'" + key + "' is one of " + String.join(" and ", known) + ".";
    part.find(
        Diagnostic.of(CampaignRules.VALUE_RANGE, message, part.at(key))
            .withHint(NearestName.hint(text, known)));
    return usual;
  }
}

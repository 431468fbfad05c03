package dev.eventchain.pipeline.campaign;

import static java.util.stream.Collectors.joining;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.SearchSettings;
import dev.eventchain.pipeline.campaign.result.CampaignPage;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignSummary;
import dev.eventchain.pipeline.campaign.result.CampaignTable;
import dev.eventchain.pipeline.search.SearchMethod;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/** Result of a search, as findings, as text and as a table. */
final class SearchReport {

  private final CampaignPlan plan;
  private final SearchSpace space;
  private final SearchWork.Result search;
  private final List<SearchFinds.Find> finds;

  SearchReport(
      CampaignPlan plan,
      SearchSpace space,
      SearchWork.Result search,
      List<SearchFinds.Find> finds) {
    this.plan = plan;
    this.space = space;
    this.search = search;
    this.finds = List.copyOf(finds);
  }

  /** Returns the runs as a table: with the number of the seed, and that of the run within it. */
  byte[] table() {
    Function<Function<SearchRun, Integer>, List<String>> column =
        value -> search.runs().stream().map(value).map(String::valueOf).toList();
    return new CampaignTable(plan.names(), search.rows())
        .with("search_seed", column.apply(SearchRun::seed))
        .with("search_run", column.apply(SearchRun::order))
        .csv();
  }

  /**
   * Returns a finding for each find, one if few of the runs were simulated, and one if there was
   * nothing to go by.
   *
   * @param files the path of each find's scenario
   */
  List<Diagnostic> findings(List<String> files) {
    SourceLocation place = SourceLocation.of(plan.file());
    List<Diagnostic> findings = new ArrayList<>();
    for (int i = 0; i < finds.size(); i++) {
      CampaignRow simple = finds.get(i).simple();
      findings.add(
          Diagnostic.of(
                  CampaignRules.SEARCH_FOUND,
                  "With %s, this fails: %s."
                      .formatted(simple.id().words(plan), simple.result().reason()),
                  place)
              .withHint("Its scenario is " + files.get(i) + "; --keep makes it one of yours."));
    }
    if (isCutShort()) {
      findings.add(
          Diagnostic.of(
                  CampaignRules.SEARCH_FEW,
                  String.format(
                      Locale.ROOT,
                      "Only %d of %d runs were simulated: no other cases were left.",
                      search.runs().size(),
                      plan.search().runs()),
                  place)
              .withHint("Loosen a condition under 'where', or give the factors more values."));
    }
    if (search.isFlat()) {
      findings.add(nothingToGoBy(place));
    }
    return findings;
  }

  private Diagnostic nothingToGoBy(SourceLocation place) {
    String which =
        plan.search().criterion().map(it -> "'" + it.text() + "' has").orElse("No criterion has");
    return Diagnostic.of(
            CampaignRules.SEARCH_NOTHING,
            which
                + (plan.search().criterion().isPresent() ? " no" : " a")
                + " margin that differs between the first cases, so the others were drawn at"
                + " random.",
            place)
        .withHint("Widen the factors, or minimise a criterion with a margin.");
  }

  /** Returns whether a search that did not stop at a find saw less than half of what was asked. */
  private boolean isCutShort() {
    boolean stopped = plan.search().stopsAtFirst() && !finds.isEmpty();
    return !stopped && 2 * search.runs().size() < plan.search().runs();
  }

  /**
   * Returns what was found, in words.
   *
   * @param more the number of cases that were simulated to make the finds simpler
   */
  String text(List<String> files, int more) {
    StringBuilder text = new StringBuilder(new CampaignSummary(plan, search.rows()).text());
    for (SearchObjective.Smallest each : SearchObjective.smallest(search.rows())) {
      text.append(
          "smallest margin of '%s': %s (%s)%n"
              .formatted(
                  brief(each.margin().name()),
                  CampaignPage.margin(each.margin()),
                  each.row().id().words(plan)));
    }
    text.append(found(files));
    int sets = SearchFinds.sets(search.runs()).size();
    if (sets > SearchFinds.MOST_SETS) {
      text.append(
          String.format(
              Locale.ROOT,
              "%d more sets of criteria fail, which the table has%n",
              sets - SearchFinds.MOST_SETS));
    }
    if (more > 0) {
      String cases = Coverage.counted(more, "more case");
      text.append("%s to tell finds apart and to make them simpler%n".formatted(cases));
    }
    return text.append(notSearched()).toString();
  }

  private String found(List<String> files) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < finds.size(); i++) {
      SearchFinds.Find find = finds.get(i);
      text.append(
          String.format(
              Locale.ROOT,
              "found: %s: %s, by %s (case %d made simpler)%n",
              files.get(i),
              find.simple().id().words(plan),
              find.criteria().stream().map(SearchReport::brief).collect(joining("; ")),
              find.run() + 1));
    }
    return text.toString();
  }

  /** Returns what was searched, and that this is not all there is. */
  private String notSearched() {
    SearchSettings settings = plan.search();
    boolean random = search.isFlat() || settings.method() == SearchMethod.RANDOM;
    String how =
        random
            ? "at random"
            : "by " + settings.method().key() + " with " + counted(settings.seeds());
    String stopped =
        settings.stopsAtFirst() && !finds.isEmpty() ? "It stopped at the first failure. " : "";
    String where = plan.conditions().isEmpty() ? "" : ", as far as the conditions keep it";
    return "Searched %s: %s%s. %sThat %s found in %s does not prove that there is %s.%n"
        .formatted(
            how,
            space.words(),
            where,
            stopped,
            finds.isEmpty() ? "nothing was" : "nothing else was",
            Coverage.counted(search.runs().size(), "run"),
            finds.isEmpty() ? "nothing" : "nothing else");
  }

  /** Returns the beginning of a criterion's name: that of a formula has the formula, too. */
  private static String brief(String name) {
    int end = name.indexOf(" (");
    return end < 0 ? name : name.substring(0, end);
  }

  private static String counted(int seeds) {
    return Coverage.counted(seeds, "seed");
  }
}

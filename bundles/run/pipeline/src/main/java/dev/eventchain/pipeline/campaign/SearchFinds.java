package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * The distinct failures among the runs of a search, each with the simplest values that fail alike.
 */
final class SearchFinds {

  /** More sets of criteria than these are not followed. */
  static final int MOST_SETS = 10;

  /** Failures of the same criteria. */
  private static final int MOST_OF_A_SET = 4;

  /** Cases tried to tell failures of the same criteria apart. */
  private static final int MOST_BETWEEN = 12;

  private static final double[] SHARES_BETWEEN = {0.5, 0.25, 0.75};
  private static final int MOST_DIGITS = 7;

  private final SearchSpace space;
  private final Function<CampaignCase, CompletableFuture<CaseResult>> simulation;
  private final List<Optional<BigDecimal>> usual;
  private final Set<CampaignCase> asked = new ConcurrentSkipListSet<>(CampaignCase.ORDER);

  /**
   * A failure.
   *
   * @param simple the case with the simplest values
   * @param run the index of the run in which it was found
   * @param criteria the names of those that fail
   */
  record Find(CampaignRow simple, int run, Set<String> criteria) {}

  /**
   * Creates the search for simple failures.
   *
   * @param usual the values of factors in the scenario as it is written; empty where it has none
   */
  SearchFinds(
      SearchSpace space,
      List<Optional<BigDecimal>> usual,
      Function<CampaignCase, CompletableFuture<CaseResult>> simulation) {
    this.space = space;
    this.usual = List.copyOf(usual);
    this.simulation = simulation;
  }

  /** Returns the failures in the order in which they were found. */
  List<Find> of(List<SearchRun> runs) {
    List<Supplier<List<SearchRun>>> groups =
        sets(runs).values().stream()
            .limit(MOST_SETS)
            .map(group -> (Supplier<List<SearchRun>>) () -> distinct(group))
            .toList();
    List<Supplier<Find>> finds =
        SearchWork.inParallel(groups).stream()
            .flatMap(List::stream)
            .map(run -> (Supplier<Find>) () -> simplest(run, runs.indexOf(run)))
            .toList();
    Map<CampaignCase, Find> once = new LinkedHashMap<>();
    SearchWork.inParallel(finds).stream()
        .sorted(Comparator.comparingInt(Find::run))
        .forEach(find -> once.putIfAbsent(find.simple().id(), find));
    return List.copyOf(once.values());
  }

  /** Returns the failed runs by the criteria that failed. */
  static Map<Set<String>, List<SearchRun>> sets(Collection<SearchRun> runs) {
    Map<Set<String>, List<SearchRun>> sets = new LinkedHashMap<>();
    for (SearchRun run : runs) {
      if (run.isFailed()) {
        sets.computeIfAbsent(SearchRun.failed(run.row().result()), key -> new ArrayList<>())
            .add(run);
      }
    }
    return sets;
  }

  /** Returns the cases that were simulated for it. */
  Set<CampaignCase> asked() {
    return asked;
  }

  private CaseResult result(CampaignCase each) {
    asked.add(each);
    return simulation.apply(each).join();
  }

  /** Returns those runs of failures of the same criteria between which a case passes. */
  private List<SearchRun> distinct(List<SearchRun> group) {
    List<SearchRun> distinct = new ArrayList<>(group.subList(0, 1));
    List<SearchRun> others = new ArrayList<>(group.subList(1, group.size()));
    int tried = 0;
    while (!others.isEmpty() && tried < MOST_BETWEEN && distinct.size() < MOST_OF_A_SET) {
      SearchRun farthest = others.get(0);
      for (SearchRun each : others) {
        farthest = distance(each, distinct) > distance(farthest, distinct) ? each : farthest;
      }
      others.remove(farthest);
      boolean passes = false;
      for (int i = 0; i < SHARES_BETWEEN.length && !passes; i++, tried++) {
        passes = passes(farthest.towards(nearest(farthest, distinct), SHARES_BETWEEN[i]));
      }
      if (passes) {
        distinct.add(farthest);
      }
    }
    return distinct;
  }

  private static SearchRun nearest(SearchRun run, List<SearchRun> others) {
    SearchRun nearest = others.get(0);
    for (SearchRun each : others) {
      nearest = run.distance(each) < run.distance(nearest) ? each : nearest;
    }
    return nearest;
  }

  private static double distance(SearchRun run, List<SearchRun> others) {
    return run.distance(nearest(run, others));
  }

  private boolean passes(double[] point) {
    CampaignCase each = space.at(point);
    return space.keeps(each) && result(each).label() == Label.PASSED;
  }

  /** Returns the find with the scenario's own values where they fail, too, and with few digits. */
  private Find simplest(SearchRun run, int index) {
    Set<String> criteria = SearchRun.failed(run.row().result());
    CampaignRow simple = run.row();
    CampaignRow before;
    do {
      before = simple;
      for (int i = 0; i < usual.size(); i++) {
        int factor = i;
        Optional<BigDecimal> value = usual.get(i).filter(it -> space.spans(factor, it));
        simple = value.isPresent() ? with(simple, i, value.get(), criteria) : simple;
      }
    } while (!simple.equals(before));
    for (int i = 0; i < usual.size(); i++) {
      simple = rounded(simple, i, criteria);
    }
    return new Find(simple, index, criteria);
  }

  /** Returns a case with another value of a factor if it fails alike, else the same case. */
  private CampaignRow with(CampaignRow row, int factor, BigDecimal value, Set<String> criteria) {
    CampaignCase other = row.id().with(factor, value);
    if (row.id().values().get(factor).compareTo(value) == 0 || !space.keeps(other)) {
      return row;
    }
    CaseResult result = result(other);
    boolean alike = result.label() == Label.FAILED && SearchRun.failed(result).equals(criteria);
    return alike ? new CampaignRow(other, result) : row;
  }

  private CampaignRow rounded(CampaignRow row, int factor, Set<String> criteria) {
    BigDecimal value = row.id().values().get(factor);
    boolean isUsual = usual.get(factor).filter(it -> it.compareTo(value) == 0).isPresent();
    if (isUsual || !space.levels(factor).isContinuous()) {
      return row;
    }
    for (int digits = 0; digits <= MOST_DIGITS; digits++) {
      BigDecimal round =
          digits == 0
              ? BigDecimal.ZERO
              : value.round(new MathContext(digits, RoundingMode.HALF_EVEN));
      if (round.compareTo(value) == 0) {
        return row;
      }
      CampaignRow other = space.spans(factor, round) ? with(row, factor, round, criteria) : row;
      if (!other.equals(row)) {
        return other;
      }
    }
    return row;
  }
}

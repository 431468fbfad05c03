package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.search.IndependentSearch;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;

/**
 * The runs of one of the independent searches. Criteria that have failed no longer lead it, until
 * all have: so it comes to other failures.
 */
final class SeedRuns implements IndependentSearch.Function {

  /** The place of a run among those of all seeds, whatever the time at which it was simulated. */
  record Place(int order, int seed) {

    static final Comparator<Place> ORDER =
        Comparator.comparingInt(Place::order).thenComparingInt(Place::seed);

    /** After all others. */
    static final Place NOWHERE = new Place(Integer.MAX_VALUE, Integer.MAX_VALUE);
  }

  private final int seed;
  private final SearchSpace space;
  private final SearchObjective objective;
  private final Function<CampaignCase, CompletableFuture<CaseResult>> simulation;
  private final AtomicReference<Place> end;
  private final boolean stopsAtFirst;
  private final Map<CampaignCase, CaseResult> known = new HashMap<>();
  private final Set<String> failedBefore = new TreeSet<>();
  private final List<SearchRun> runs = new ArrayList<>();

  /**
   * Creates the runs of a seed.
   *
   * @param end the place of the first failed case of all seeds, if they stop there
   */
  SeedRuns(int seed, SearchWork work, SearchObjective objective, AtomicReference<Place> end) {
    this.seed = seed;
    this.space = work.space();
    this.objective = objective;
    this.simulation = work.simulation();
    this.end = end;
    this.stopsAtFirst = work.settings().stopsAtFirst();
    for (SearchRun each : work.first()) {
      known.put(each.row().id(), each.row().result());
      leaveOut(SearchRun.failed(each.row().result()));
    }
  }

  List<SearchRun> runs() {
    return runs;
  }

  private void leaveOut(Set<String> failed) {
    failedBefore.addAll(failed);
    if (failedBefore.containsAll(objective.criteria())) {
      failedBefore.clear();
    }
  }

  /**
   * Returns the value by which this seed is led: that of one criterion, another one for each seed,
   * the nearest to failing first. The smallest of all would be that of one that comes near to 0
   * everywhere and never fails, and hide the others.
   */
  double value(CaseResult result) {
    List<String> open = new ArrayList<>(objective.criteria());
    open.removeAll(failedBefore);
    return open.isEmpty()
        ? objective.value(result)
        : objective.value(result, open.get((seed - 1) % open.size()));
  }

  @Override
  public boolean isOpen() {
    return Place.ORDER.compare(new Place(runs.size() + 1, seed), end.get()) < 0;
  }

  @Override
  public IndependentSearch.Answer at(double[] point) {
    CampaignCase id = space.at(point);
    if (!space.keeps(id)) {
      return new IndependentSearch.Answer(SearchObjective.UNJUDGED, false, false);
    }
    CaseResult before = known.get(id);
    if (before != null) {
      return new IndependentSearch.Answer(value(before), false, false);
    }
    CaseResult result = simulation.apply(id).join();
    known.put(id, result);
    List<Double> shares = Arrays.stream(point).boxed().toList();
    runs.add(new SearchRun(seed, runs.size() + 1, shares, new CampaignRow(id, result)));
    double value = value(result);
    Set<String> failed = SearchRun.failed(result);
    boolean isFind = result.label() == Label.FAILED && !failedBefore.containsAll(failed);
    if (isFind) {
      leaveOut(failed);
      if (stopsAtFirst) {
        end.accumulateAndGet(new Place(runs.size(), seed), SeedRuns::earlier);
      }
    }
    return new IndependentSearch.Answer(value, true, isFind);
  }

  private static Place earlier(Place one, Place other) {
    return Place.ORDER.compare(one, other) <= 0 ? one : other;
  }
}

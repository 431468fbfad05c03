package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.SearchSettings;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.search.IndependentSearch;
import dev.eventchain.pipeline.search.SearchMethod;
import dev.eventchain.simulation.verdict.CaseResult;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * A search. A quarter of the runs is spread over the space. The others are divided among the seeds,
 * each of which begins at another one of the best places so far. The requested cases depend on the
 * results of others only, not on when these come.
 */
final class SearchWork {

  /** Runs at first, even if a quarter of all is less: fewer say nothing about margins. */
  private static final int FEWEST = 8;

  private static final int PART_OF_THE_FIRST = 4;

  /** Runs after which a search that stops at the first failure looks for one. */
  private static final int TOGETHER = 8;

  private final SearchSpace space;
  private final SearchSettings settings;
  private final long seed;
  private final Function<CampaignCase, CompletableFuture<CaseResult>> simulation;
  private final List<SearchRun> first = new ArrayList<>();

  /**
   * Result of a search.
   *
   * @param runs in an order that is the same each time
   * @param isFlat whether the seeds had nothing to go by
   */
  record Result(List<SearchRun> runs, boolean isFlat) {

    /** Copies the list. */
    Result {
      runs = List.copyOf(runs);
    }

    List<CampaignRow> rows() {
      return runs.stream().map(SearchRun::row).toList();
    }
  }

  /**
   * Creates a search.
   *
   * @param simulation of a case, which is under way when it returns
   */
  SearchWork(
      SearchSpace space,
      SearchSettings settings,
      long seed,
      Function<CampaignCase, CompletableFuture<CaseResult>> simulation) {
    this.space = space;
    this.settings = settings;
    this.seed = seed;
    this.simulation = simulation;
  }

  SearchSpace space() {
    return space;
  }

  SearchSettings settings() {
    return settings;
  }

  Function<CampaignCase, CompletableFuture<CaseResult>> simulation() {
    return simulation;
  }

  /** Returns the runs that are spread over the space. */
  List<SearchRun> first() {
    return first;
  }

  /** Searches. There are no runs if the conditions keep none of the first ones. */
  Result run() {
    spread();
    SearchObjective objective =
        new SearchObjective(
            first.stream().map(each -> each.row().result()).toList(),
            settings.criterion().map(SearchSettings.Named::text));
    List<SearchRun> runs = new ArrayList<>(first);
    boolean goesOn = !first.isEmpty() && !hasEnded();
    if (goesOn) {
      runs.addAll(seeds(objective));
    }
    return new Result(runs, goesOn && objective.isFlat());
  }

  private boolean hasEnded() {
    return settings.stopsAtFirst() && first.stream().anyMatch(SearchRun::isFailed);
  }

  private void spread() {
    int most = Math.min(settings.runs(), Math.max(FEWEST, settings.runs() / PART_OF_THE_FIRST));
    Map<CampaignCase, double[]> points = new LinkedHashMap<>();
    for (double[] point : space.spread(most, new SplittableRandom(seed))) {
      CampaignCase id = space.at(point);
      if (space.keeps(id)) {
        points.putIfAbsent(id, point);
      }
    }
    List<CampaignCase> cases = List.copyOf(points.keySet());
    int together = settings.stopsAtFirst() ? TOGETHER : cases.size();
    for (int i = 0; i < cases.size() && !hasEnded(); i += together) {
      List<CampaignCase> next = cases.subList(i, Math.min(i + together, cases.size()));
      List<CompletableFuture<CaseResult>> results = next.stream().map(simulation).toList();
      for (int k = 0; k < next.size(); k++) {
        List<Double> shares = Arrays.stream(points.get(next.get(k))).boxed().toList();
        CampaignRow row = new CampaignRow(next.get(k), results.get(k).join());
        first.add(new SearchRun(0, first.size() + 1, shares, row));
      }
    }
  }

  private List<SearchRun> seeds(SearchObjective objective) {
    AtomicReference<SeedRuns.Place> end = new AtomicReference<>(SeedRuns.Place.NOWHERE);
    SplittableRandom random = new SplittableRandom(~seed);
    SearchMethod method = objective.isFlat() ? SearchMethod.RANDOM : settings.method();
    int left = settings.runs() - first.size();
    List<Supplier<List<SearchRun>>> searches = new ArrayList<>();
    for (int i = 0; i < settings.seeds(); i++) {
      SeedRuns runs = new SeedRuns(i + 1, this, objective, end);
      int own = left / settings.seeds() + (i < left % settings.seeds() ? 1 : 0);
      double[] start = start(i, runs);
      IndependentSearch search = new IndependentSearch(method, runs, own, random.nextLong());
      searches.add(
          () -> {
            search.run(start);
            return runs.runs();
          });
    }
    return inParallel(searches).stream()
        .flatMap(List::stream)
        .filter(run -> SeedRuns.Place.ORDER.compare(place(run), end.get()) <= 0)
        .sorted(Comparator.comparing(SearchWork::place, SeedRuns.Place.ORDER))
        .toList();
  }

  private static SeedRuns.Place place(SearchRun run) {
    return new SeedRuns.Place(run.order(), run.seed());
  }

  /** Returns the place where the seed with an index begins. */
  private double[] start(int index, SeedRuns runs) {
    List<SearchRun> best =
        first.stream()
            .sorted(Comparator.comparingDouble(each -> runs.value(each.row().result())))
            .toList();
    return best.get(index % best.size()).point().stream().mapToDouble(it -> it).toArray();
  }

  /** Does all tasks at the same time, and returns their results in the order of the tasks. */
  static <T> List<T> inParallel(List<Supplier<T>> tasks) {
    ExecutorService threads = Executors.newFixedThreadPool(Math.max(1, tasks.size()));
    try {
      return tasks.stream()
          .map(task -> CompletableFuture.supplyAsync(task, threads))
          .toList()
          .stream()
          .map(CompletableFuture::join)
          .toList();
    } finally {
      threads.shutdown();
    }
  }
}

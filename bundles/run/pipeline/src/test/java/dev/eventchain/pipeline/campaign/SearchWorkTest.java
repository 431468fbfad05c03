package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.pipeline.campaign.SearchFinds.Find;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.Conditions;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests searches on results that are computed instead of simulated. */
class SearchWorkTest {

  private static final String TWO_FACTORS =
      """
      scenario: s
      factors:
        x: {path: x, uniform: [0, 10]}
        y: {path: y, uniform: [-5, 5]}
      """;

  @TempDir Path folder;
  private final List<CampaignCase> simulated = Collections.synchronizedList(new ArrayList<>());

  /** Results of cases, from the values of the factors. */
  private interface World {
    CaseResult of(double... values);
  }

  private CampaignPlan plan(String text) throws IOException {
    return CampaignReader.readForSearch(Files.writeString(folder.resolve("a.yaml"), text))
        .get(0)
        .ofSearch();
  }

  private Function<CampaignCase, CompletableFuture<CaseResult>> simulation(
      World world, Executor executor) {
    return each -> {
      simulated.add(each);
      double[] values = each.values().stream().mapToDouble(BigDecimal::doubleValue).toArray();
      return CompletableFuture.supplyAsync(() -> world.of(values), executor);
    };
  }

  private SearchWork.Result search(CampaignPlan plan, World world) {
    return new SearchWork(
            new SearchSpace(plan), plan.search(), plan.seed(), simulation(world, Runnable::run))
        .run();
  }

  private SearchFinds finds(CampaignPlan plan, World world, Double... usual) {
    return new SearchFinds(
        new SearchSpace(plan),
        Arrays.stream(usual).map(it -> Optional.of(BigDecimal.valueOf(it))).toList(),
        simulation(world, Runnable::run));
  }

  private static CriterionMargin margin(String name, double margin, String unit) {
    Label label = margin >= 0 ? Label.PASSED : Label.FAILED;
    return new CriterionMargin(name, label, OptionalDouble.of(margin), unit);
  }

  private static CaseResult result(CriterionMargin... criteria) {
    boolean failed = Arrays.stream(criteria).anyMatch(each -> each.label() == Label.FAILED);
    return new CaseResult(
        failed ? Label.FAILED : Label.PASSED, "", List.of(criteria), OptionalDouble.empty(), 1);
  }

  /** Fails in one hundredth of the space, of which the margin says the way. */
  private static CaseResult smallPit(double... at) {
    double distance = Math.hypot((at[0] - 7.3) / 10, (at[1] + 1.2) / 10);
    return result(margin("gap", distance - 0.05, "m"), margin("time", 3 - at[1] / 100, "s"));
  }

  @Test
  void aSmallRegionIsFoundByTheMargin() throws IOException {
    for (int seed = 1; seed <= 5; seed++) {
      CampaignPlan plan = plan(TWO_FACTORS + "seed: " + seed + "\nsearch: {seeds: 2}\n");
      SearchWork.Result found = search(plan, SearchWorkTest::smallPit);
      assertEquals(200, found.runs().size());
      assertTrue(found.runs().stream().anyMatch(SearchRun::isFailed), "seed " + seed);
    }
  }

  /** The margin of one criterion is small everywhere, and leads away from where the other fails. */
  @Test
  void eachSeedIsLedByACriterionOfItsOwn() throws IOException {
    for (int seed = 1; seed <= 5; seed++) {
      CampaignPlan plan = plan(TWO_FACTORS + "seed: " + seed + "\nsearch: {seeds: 2}\n");
      World world =
          at ->
              result(smallPit(at).criteria().get(0), margin("always near", 0.02 + at[0] / 50, "s"));
      SearchWork.Result found = search(plan, world);
      assertTrue(found.runs().stream().anyMatch(SearchRun::isFailed), "seed " + seed);
    }
  }

  @Test
  void theFirstFailureEndsItAtTheSamePlaceWhateverIsSimulatedFirst() throws IOException {
    CampaignPlan plan = plan(TWO_FACTORS + "search: {seeds: 3, stop: first_failure}\n");
    List<SearchRun> once = search(plan, SearchWorkTest::smallPit).runs();
    int failed = once.stream().map(SearchRun::isFailed).toList().indexOf(true);
    assertTrue(failed >= 50 && failed == once.size() - 1, () -> failed + " of " + once.size());
    Executor late =
        task ->
            new Thread(
                    () -> {
                      sleep(simulated.size() % 3);
                      task.run();
                    })
                .start();
    SearchWork.Result again =
        new SearchWork(
                new SearchSpace(plan),
                plan.search(),
                plan.seed(),
                simulation(SearchWorkTest::smallPit, late))
            .run();
    assertEquals(once, again.runs());
  }

  private static void sleep(long milliseconds) {
    try {
      Thread.sleep(milliseconds);
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  /** A metre of a margin that differs by kilometres is less than a second of one of seconds. */
  @Test
  void marginsOfDifferentUnitsAreComparedByHowMuchTheyDiffer() {
    List<CaseResult> first = new ArrayList<>();
    for (int i = 0; i <= 10; i++) {
      first.add(result(margin("far", 1000 * i, "m"), margin("late", 0.1 * i, "s")));
    }
    SearchObjective objective = new SearchObjective(first, Optional.empty());
    CaseResult each = result(margin("far", 800, "m"), margin("late", 0.4, "s"));
    assertEquals(0.1, objective.value(each), 1e-9);
    assertEquals(0.5, objective.value(each, "late"), 1e-9);
    SearchObjective one = new SearchObjective(first, Optional.of("late"));
    assertEquals(0.5, one.value(each), 1e-9);
    assertEquals(SearchObjective.UNJUDGED, objective.value(CaseResult.error("raised")));
    CaseResult failed =
        new CaseResult(
            Label.FAILED,
            "",
            List.of(
                margin("far", 5, "m"),
                new CriterionMargin("lamp", Label.FAILED, OptionalDouble.empty(), "")),
            OptionalDouble.empty(),
            1);
    assertTrue(objective.value(failed) < 0, "a failure without a margin is one");
  }

  @Test
  void whereNoMarginDiffersPointsAreDrawnAtRandom() throws IOException {
    CampaignPlan plan = plan(TWO_FACTORS + "search: {runs: 40}\n");
    SearchWork.Result found = search(plan, at -> result(margin("gap", 3, "m")));
    assertTrue(found.isFlat());
    assertEquals(40, found.runs().size());
    assertEquals(40, Set.copyOf(found.rows()).size());
  }

  @Test
  void conditionsAreKeptAndSpacesOfFewValuesEnd() throws IOException {
    CampaignPlan plan =
        plan(
            """
            scenario: s
            factors:
              x: {path: x, values: [1, 2, 3, 4]}
              y: {path: y, values: [1, 2, 3, 4]}
            where: [x + y < 6]
            """);
    SearchWork.Result found = search(plan, at -> result(margin("sum", at[0] + at[1], "m")));
    assertEquals(10, new HashSet<>(simulated).size(), simulated::toString);
    assertTrue(
        found.rows().stream()
            .allMatch(row -> new Conditions(plan, plan.conditions()).keep(row.id())));
    CampaignPlan none = plan(TWO_FACTORS + "where: [x > 20]\n");
    assertEquals(List.of(), search(none, SearchWorkTest::smallPit).runs());
  }

  /** Two regions of one criterion, and one of another. */
  private static CaseResult threePits(double... at) {
    double left = Math.hypot(at[0] - 2, at[1]) - 1.5;
    double right = Math.hypot(at[0] - 8, at[1]) - 1.5;
    double lower = Math.hypot(at[0] - 5, at[1] + 4) - 1;
    return result(margin("gap", Math.min(left, right), "m"), margin("time", lower, "s"));
  }

  @Test
  void failuresAreDistinctByTheirCriteriaAndByWhatPassesBetween() throws IOException {
    CampaignPlan plan = plan(TWO_FACTORS);
    SearchWork.Result found = search(plan, SearchWorkTest::threePits);
    SearchFinds finds = finds(plan, SearchWorkTest::threePits, 5.0, 0.0);
    List<Find> each = finds.of(found.runs());
    assertEquals(
        List.of("[gap]", "[gap]", "[time]"),
        each.stream().map(it -> it.criteria().toString()).sorted().toList());
    List<String> simple = each.stream().map(it -> it.simple().id().words(plan)).sorted().toList();
    assertEquals(List.of("x = 3, y = 0", "x = 5, y = -4", "x = 9, y = 0"), simple);
    assertTrue(finds.asked().size() < 60, () -> "" + finds.asked().size());
  }

  @Test
  void valuesBecomeThoseOfTheScenarioUnlessTheyAreOutside() throws IOException {
    CampaignPlan plan = plan(TWO_FACTORS + "where: [y < 4.5]\n");
    World fails = at -> result(margin("gap", at[0] < 3.14 ? -1 : 1, "m"));
    SearchWork.Result found = search(plan, fails);
    Find inside = finds(plan, fails, 5.0, 2.5).of(found.runs()).get(0);
    assertEquals(0, new BigDecimal("2.5").compareTo(inside.simple().id().values().get(1)));
    assertTrue(inside.simple().id().values().get(0).precision() == 1, inside::toString);
    Find outside = finds(plan, fails, 1.0, 4.6).of(found.runs()).get(0);
    assertEquals(0, BigDecimal.ONE.compareTo(outside.simple().id().values().get(0)));
    assertTrue(outside.simple().id().values().get(1).precision() == 1, outside::toString);
  }
}

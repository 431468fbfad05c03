package dev.eventchain.simulation.judge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.WorldRuns;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests what a judge keeps of the runs that it judges. */
class ScenarioJudgeTest {

  @TempDir Path folder;

  /** Mutation testing judges thousands of runs with one judge. */
  @Test
  void aJudgedRunIsNotKept() throws Exception {
    AebProject project = new AebProject(folder);
    Scenario scenario = AebProject.scenario("stopped-vehicle-50");
    ScenarioJudge judge =
        new ScenarioJudge(project.request(List.of(scenario)).simulatedChain(), List.of(), false);
    WeakReference<Trace> judged = judged(judge, scenario);
    for (int i = 0; i < 100 && judged.get() != null; i++) {
      System.gc();
      Thread.sleep(10);
    }
    assertNull(judged.get());
  }

  @Test
  void nothingIsTestedWhereAManeuverNeverBegan() throws Exception {
    List<CriterionResult> met = brakingWhile("", "ego.speed < 12 m/s");
    assertTrue(met.stream().anyMatch(CriterionResult::passed), met::toString);
    List<CriterionResult> never = brakingWhile("", "ego.speed > 99 m/s");
    assertTrue(
        never.subList(0, 2).stream().allMatch(each -> each.measured().contains(NEVER)),
        never::toString);
    List<CriterionResult> optional = brakingWhile(", optional: true", "ego.speed > 99 m/s");
    assertTrue(optional.stream().anyMatch(CriterionResult::passed), optional::toString);
  }

  /** Braking at once before a car that stands is no test of what brakes 2 s before it. */
  @Test
  void nothingIsTestedOfARunThatIsNotTheTest() throws Exception {
    List<CriterionResult> kept = brakingUnder("always[3, 4] ego.acceleration >= -1 m/s2");
    assertTrue(kept.stream().anyMatch(CriterionResult::passed), kept::toString);
    List<CriterionResult> other = brakingUnder("always[0, 1] ego.acceleration >= -1 m/s2");
    assertTrue(
        other.subList(0, 2).stream()
            .allMatch(
                each ->
                    !each.tested()
                        && each.measured().startsWith("this was not the test, the test speed:")),
        other::toString);
    List<CriterionResult> unknown = brakingUnder("always output(AEB-9, bool)");
    assertTrue(
        unknown.get(0).measured().startsWith("nobody knows if this was the test"),
        unknown::toString);
  }

  private List<CriterionResult> brakingUnder(String condition) throws Exception {
    String scenario =
        """
        name: approach
        title: A car stands
        requirements: [AEB-1]
        duration_s: 8
        ego: {speed_kmh: 50}
        actors: [{gap_m: 60, speed_kmh: 0}]
        test_conditions: [{name: the test speed, formula: "%s"}]
        accept: {no_impact: true, stops: true}
        """
            .formatted(condition);
    Scenario read = Scenario.parse(SourceText.of("s.yaml", scenario), Bench.carla());
    Path project = Files.createTempDirectory(folder, "approach");
    ScenarioJudge judge =
        new ScenarioJudge(
            new AebProject(project).request(List.of(read)).simulatedChain(), List.of(), false);
    return judge.criteria(braking(read), true);
  }

  private static final String NEVER =
      "a maneuver never began: that of car 1 when ego.speed > 99 m/s";

  /** Brakes at once before a car that waits for something. */
  private List<CriterionResult> brakingWhile(String optional, String when) throws Exception {
    String scenario =
        """
        name: waiting
        title: A car waits
        requirements: [AEB-1]
        duration_s: 8
        ego: {speed_kmh: 50}
        actors:
          - gap_m: 60
            speed_kmh: 0
            maneuvers: [{when: %s, speed_kmh: 3, acceleration_mps2: 1%s}]
        accept: {no_impact: true, stops: true}
        """
            .formatted(when, optional);
    Scenario read = Scenario.parse(SourceText.of("s.yaml", scenario), Bench.carla());
    Path project = Files.createTempDirectory(folder, "waiting");
    ScenarioJudge judge =
        new ScenarioJudge(
            new AebProject(project).request(List.of(read)).simulatedChain(), List.of(), false);
    return judge.criteria(braking(read), true);
  }

  @Test
  void whatAnImpactLeavesOpenIsItsConsequence() throws Exception {
    String kept = "no_impact: true, stops: true, minimal_gap_m: 1, never_brakes: true";
    List<CriterionResult> hit = afterAnImpact(kept);
    assertEquals(5, hit.size(), hit::toString);
    assertEquals(
        List.of("no impact", "control commands arrive at least once a second"),
        hit.stream().filter(each -> each.cause().isEmpty()).map(CriterionResult::text).toList());
    assertEquals("no impact", causeOf(hit.get(1), hit));
    assertTrue(hit.stream().anyMatch(each -> !each.tested()), hit::toString);
    String allowed = "maximal_impact_speed_kmh: 90, never_brakes: true";
    assertTrue(
        afterAnImpact(allowed).stream().allMatch(each -> each.cause().isEmpty()),
        "an impact that is allowed is no finding, so that nothing is a consequence of one");
    List<CriterionResult> tooFast = afterAnImpact("maximal_impact_speed_kmh: 9, stops: true");
    assertEquals("any impact is at 9.0 km/h or less", causeOf(tooFast.get(0), tooFast));
    assertTrue(tooFast.toString().contains("impact at 50.0 km/h after"), tooFast::toString);
    assertEquals("", causeOf(afterAnImpact("stops: true").get(0), List.of()));
  }

  @Test
  void anOptionalCriterionIsAskedOnceItsPremiseCameTrue() throws Exception {
    String allowed = "maximal_impact_speed_kmh: 90, ";
    String met = "always[0, 7] (ttc < 1 s implies eventually[0, 0.2] ego.speed > 1 m/s)";
    String never = "always[0, 7] (ego.speed > 15 m/s implies eventually[0, 0.2] brake > 0)";
    assertEquals(List.of(), unasked(allowed, met, 0.0), "the impact ended the run too soon");
    assertEquals(List.of(never), unasked(allowed, never, 0.0));
    assertEquals(List.of(met), unasked(allowed, met, 1.0), "the vehicle brakes in time");
  }

  private static final String MET = "ttc < 1 s implies eventually[0, 0.2] ego.speed > 1 m/s";
  private static final String NEVER_MET = "brake > 0.5 implies ego.speed > 0 m/s";

  /** Formulas that the impact, which ends the run, leaves undecided. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "always[0, 7] ((" + MET + ") and (" + NEVER_MET + "))",
        "always[0, 7] (" + NEVER_MET + ") and always[0, 7] (" + MET + ")",
        "always[0, 7] (ttc < 2 s implies (" + MET + "))",
        "always[0, 7] (ttc < 1 s implies (ego.speed > 1 m/s and (" + NEVER_MET + ")))",
        "eventually[0, 7] (brake > 0.5)",
      })
  void whatARunCameToIsNotLeftAside(String formula) throws Exception {
    assertEquals(List.of(), unasked("maximal_impact_speed_kmh: 90, ", formula, 0.0));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "always[0, 7] (ttc < 1 s implies (" + NEVER_MET + "))",
        "always[0, 7] ((" + NEVER_MET + ") and (ego.speed > 15 m/s implies brake > 0))",
        "always[0, 1] (ttc < 9 s implies ego.speed > 1 m/s) and always[0, 7] (" + NEVER_MET + ")",
      })
  void whatARunDidNotComeToIsLeftAside(String formula) throws Exception {
    assertEquals(List.of(formula), unasked("maximal_impact_speed_kmh: 90, ", formula, 0.0));
  }

  /** Returns the formulas that a run with an optional one does not ask. */
  private List<String> unasked(String criteria, String formula, double brake) throws Exception {
    Scenario read =
        hit(criteria + "formulas: [{optional: true, formula: '%s'}]".formatted(formula));
    ScenarioRun run = run(read, brake);
    ScenarioJudge judge = judge(read);
    return read.criteria().stream()
        .filter(each -> judge.isUnasked(each, run))
        .map(Expectation::text)
        .toList();
  }

  private static String causeOf(CriterionResult consequence, List<CriterionResult> all) {
    return consequence
        .cause()
        .flatMap(it -> all.stream().filter(each -> each.location().equals(it.location())).findAny())
        .map(CriterionResult::text)
        .orElse("");
  }

  /** Judges a run of a vehicle that drives into a car without braking. */
  private List<CriterionResult> afterAnImpact(String criteria) throws Exception {
    Scenario read = hit(criteria);
    return judge(read).criteria(run(read, 0.0), true).stream()
        .filter(each -> !each.passed())
        .toList();
  }

  /** Who stops before it turns across the way of an oncoming car never has it ahead. */
  @Test
  void anImpactThatComesWithoutTheSoftwareIsAvoided() throws Exception {
    assertEquals(
        List.of("no impact, but one without the software"), ofOncoming("no_impact: true", 3.5));
    assertEquals(
        List.of("no impact, but one without the software"),
        ofOncoming("maximal_impact_speed_kmh: 20", 3.5));
    assertEquals(List.of("nothing ahead"), ofOncoming("no_impact: true", 0));
  }

  /** Who waits for something that never comes may be what there is to hit. */
  @Test
  void nothingAheadIsNoTestEitherWhereAManeuverNeverBegan() throws Exception {
    String waiting =
        """
        duration_s: 8
        actors:
          - gap_m: 120
            speed_kmh: 50
            lateral_offset_m: 3.5
            heading_deg: 180
            maneuvers: [{when: ego.speed > 99 m/s, lateral_offset_m: 0}]
        """;
    for (double aside : new double[] {0, 3.5}) {
      Scenario read = oncoming("no_impact: true", aside, waiting);
      assertEquals(List.of(NEVER), measured(judge(read).criteria(braking(read), true)));
      assertEquals(List.of(NEVER), measured(judge(read).criteriaWithoutEvidence(braking(read))));
    }
  }

  /** Judges a car that stops at once, and would move aside to where another one comes. */
  private List<String> ofOncoming(String criterion, double aside) throws Exception {
    Scenario read =
        oncoming(
            criterion,
            aside,
            """
            duration_s: 8
            actors: [{gap_m: 120, speed_kmh: 50, lateral_offset_m: 3.5, heading_deg: 180}]
            """);
    return measured(judge(read).criteria(braking(read), true));
  }

  private static List<String> measured(List<CriterionResult> criteria) {
    return criteria.stream().limit(1).map(CriterionResult::measured).toList();
  }

  private static Scenario oncoming(String criterion, double aside, String others) {
    return Scenario.parse(
        SourceText.of(
            "s.yaml",
            """
            name: oncoming
            title: An oncoming car
            requirements: [AEB-1]
            ego: {speed_kmh: 50, maneuvers: [{at_s: 1, lateral_offset_m: %s}]}
            accept: {%s}
            """
                    .formatted(aside, criterion)
                + others),
        Bench.carla());
  }

  private static Scenario hit(String criteria) {
    String scenario =
        """
        name: hit
        title: A car in the way
        requirements: [AEB-1]
        duration_s: 8
        ego: {speed_kmh: 50}
        actors: [{gap_m: 30, speed_kmh: 0}]
        accept: {%s}
        """
            .formatted(criteria);
    return Scenario.parse(SourceText.of("s.yaml", scenario), Bench.carla());
  }

  private ScenarioJudge judge(Scenario scenario) throws Exception {
    Path project = Files.createTempDirectory(folder, "hit");
    return new ScenarioJudge(
        new AebProject(project).request(List.of(scenario)).simulatedChain(), List.of(), false);
  }

  /** Judges a run that brakes at once, so that the criteria on impact and standstill hold. */
  private static WeakReference<Trace> judged(ScenarioJudge judge, Scenario scenario) {
    ScenarioRun run = braking(scenario);
    // Only for such criteria does the judge look at what the vehicle does without software.
    assertTrue(
        judge.criteria(run, true).stream()
            .filter(CriterionResult::passed)
            .anyMatch(each -> !each.requirements().isEmpty()));
    return new WeakReference<>(run.trace());
  }

  private static ScenarioRun braking(Scenario scenario) {
    return run(scenario, 1.0);
  }

  private static ScenarioRun run(Scenario scenario, double brake) {
    World world = WorldRuns.start(scenario);
    world.command(0, VehicleCommand.brake(brake));
    world.advanceTo(World.nanoseconds(scenario.duration()));
    if (world.impacted() && !scenario.allowsImpact()) {
      world.trace().cutShort();
    }
    return WorldRuns.of(scenario, world);
  }
}

package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.nio.file.Path;
import java.util.List;
import java.util.NavigableMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests by which criteria a case is judged: of the emergency braking, before a car that stands. */
class CaseSimulationTest {

  private static final String SCENE =
      """
      name: approach
      title: Approach
      requirements: [AEB-4]
      duration_s: 4
      ego: {speed_kmh: 50}
      actors: [%s]
      accept:
        %s
      """;

  private static final String CAR = "{gap_m: 35, speed_kmh: 0}";

  @TempDir Path folder;

  private static Scenario scenario(String actors, String accept) {
    String text = SCENE.formatted(actors, accept.replace("\n", "\n  "));
    return Scenario.parse(SourceText.of("s.yaml", text), AebProject.BENCH);
  }

  private List<CaseResult> run(Scenario... scenarios) throws Exception {
    NavigableMap<Integer, CaseResult> results = new TreeMap<>();
    SimulationRequest request = new AebProject(folder).request(List.of(scenarios));
    new CaseSimulation(request, PythonEnvironment.ensure(line -> {}))
        .run(
            scenarios.length + 1,
            number -> {
              if (number == scenarios.length) {
                scenario("{gap_m: -2, speed_kmh: 0}", "stops: true");
              }
              return new CaseSimulation.Case(scenarios[number], AebProject.BENCH);
            },
            results::put);
    return List.copyOf(results.values());
  }

  @Test
  void aCaseIsJudgedByTheCriteriaThatItIsACaseOf() throws Exception {
    List<CaseResult> results =
        run(
            scenario(CAR, "no_impact: true"),
            scenario(CAR, "minimal_gap_m: 19"),
            scenario("", "no_impact: true"),
            scenario("", "minimal_gap_m: 1"),
            scenario(CAR, "no_impact: true\nno_brake_at_ttc_s: 30"),
            scenario(
                CAR,
                """
                no_impact: true
                formulas:
                  - {optional: true, formula: "always (output(AEB-9, bool) implies brake > 0)"}\
                """),
            scenario("{gap_m: 3, speed_kmh: 0}", "never_brakes: true"));
    assertEquals(
        List.of(
            Label.PASSED, // it brakes in time
            Label.FAILED, // and comes nearer than this
            Label.PASSED, // nothing was ahead, and nothing was hit
            Label.UNTESTED, // of a gap, that says nothing
            Label.PASSED, // the second one is not about this case, the first one is
            Label.PASSED,
            Label.FAILED,
            Label.ERROR), // the last one is no scenario
        results.stream().map(CaseResult::label).toList(),
        results::toString);
    assertEquals(
        List.of(results.get(2)), results.stream().filter(CaseResult::nothingAhead).toList());
    assertTrue(results.get(1).reason().startsWith("the gap is never below 19"), results::toString);
    assertTrue(results.get(7).reason().startsWith("no scenario: At the start, "));
    assertTrue(results.get(6).impactSpeed().isPresent());
    assertEquals(
        List.of("no impact", "brake commands are from 0 to 1"),
        results.get(5).criteria().stream().map(CriterionMargin::name).limit(2).toList());
    assertEquals(
        Label.UNTESTED,
        results.get(4).criteria().stream()
            .filter(each -> each.name().startsWith("no braking while"))
            .findFirst()
            .orElseThrow()
            .label());
  }

  @Test
  void anImpactOfWhichNoCriterionSaysAnythingIsNoPass() throws Exception {
    CaseResult result = run(scenario("{gap_m: 3, speed_kmh: 0}", "brake_below_ttc_s: 2.0")).get(0);
    assertTrue(result.impactSpeed().isPresent(), result::toString);
    assertTrue(result.label() != Label.PASSED, result::toString);
  }

  /** Neither braking nor an impact is due when the car is still 44 m ahead at the end. */
  @Test
  void aCriterionThatTheRunLeavesOpenIsNoPassBesideOneThatHolds() throws Exception {
    String car = "{gap_m: 100, speed_kmh: 0}";
    CaseResult result = run(scenario(car, "never_brakes: true\nno_impact: true")).get(0);
    assertEquals(Label.UNTESTED, result.label(), result::toString);
    assertTrue(result.reason().startsWith("no impact: the run ended "), result::reason);
    assertTrue(
        result.criteria().stream()
            .anyMatch(it -> it.label() == Label.PASSED && it.name().equals("no braking at all")),
        result::toString);
  }
}

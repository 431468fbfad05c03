package dev.eventchain.simulation.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import java.util.List;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** Tests which requirements each criterion of a scenario tests. */
class NamedRequirementsTest {

  private static Scenario scenario(String requirements, String accept) {
    return Scenario.parse(
        SourceText.of(
            "s.yaml",
            """
            name: s
            title: S
            %s
            duration_s: 5
            ego: {speed_kmh: 50}
            accept:
            %s"""
                .formatted(requirements, accept.indent(2))),
        Bench.carla());
  }

  private static String tested(Scenario scenario) {
    TreeMap<String, List<String>> tested = new TreeMap<>();
    scenario
        .criteria()
        .forEach(each -> tested.put(each.text().replaceFirst(" .*", ""), each.requirements()));
    return tested.toString();
  }

  @Test
  void criteriaThatNameNoneTestThoseOfTheScenario() {
    Scenario scenario = scenario("requirements: [A, B]", "no_impact: true\nminimal_gap_m: 2");
    assertEquals("{brake=[A, B], control=[A, B], no=[A, B], the=[A, B]}", tested(scenario));
    assertEquals(List.of("A", "B"), scenario.requirements());
  }

  @Test
  void whatACriterionNamesIsLeftToIt() {
    Scenario scenario =
        scenario(
            "requirements: [A, B, C]",
            """
            no_impact: true
            stops: true
            maximal_lane_offset_m: 1
            settles:
              - {signal: ego.speed, at: 0 m/s, within: 1 m/s, from_s: 4, requirements: [C, D]}
            formulas:
              - name: quick
                formula: eventually brake > 0.5
                requirements: [B]
            requirements:
              stops: [C]
              maximal_lane_offset_m: [E]
            """);
    // "brake" and "control" are asked in every scenario, whatever it tests.
    assertEquals(
        "{brake=[A, B, C, E, D], control=[A, B, C, E, D], ego.speed=[C, D],"
            + " maximal_lane_offset_m=[E], no=[A], quick=[B], the=[C]}",
        tested(scenario));
    assertEquals(List.of("A", "B", "C", "E", "D"), scenario.requirements());
    assertEquals("s.yaml:3:1", scenario.locationOf("B").toString());
    assertEquals("s.yaml:18:5", scenario.locationOf("E").toString());
    assertEquals("s.yaml:11:", scenario.locationOf("D").toString().substring(0, 10));
  }

  @Test
  void scenarioWithoutAListTestsWhatItsCriteriaName() {
    Scenario scenario = scenario("", "no_impact: true\nstops: true\nrequirements: {stops: [A, A]}");
    assertEquals("{brake=[A], control=[A], no=[], the=[A]}", tested(scenario));
  }

  @Test
  void requirementsOfCriteriaThatThereAreNotAreRefused() {
    assertEquals("scenario.key.unknown 8:18", refused("requirements: {stops: [A]}"));
    assertEquals("scenario.key.unknown 8:18", refused("requirements: {no_impct: [A]}"));
    assertEquals("scenario.value.range 8:29", refused("requirements: {no_impact: []}"));
    assertEquals("scenario.value.type 8:29", refused("requirements: {no_impact: A}"));
    assertEquals("scenario.value.type 8:17", refused("requirements: [A]"));
  }

  private static String refused(String requirements) {
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class, () -> scenario("", "no_impact: true\n" + requirements));
    assertEquals(1, refused.diagnostics().size(), () -> refused.diagnostics().toString());
    var problem = refused.diagnostics().get(0);
    return problem.id() + " " + problem.location().line() + ":" + problem.location().column();
  }
}

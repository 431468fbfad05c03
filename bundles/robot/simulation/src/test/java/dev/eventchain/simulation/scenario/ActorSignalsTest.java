package dev.eventchain.simulation.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests formulas about actors by their names: of a walker who crosses, and of a car behind. */
class ActorSignalsTest {

  /**
   * The ego passes at 10 m/s. The walker, 0.5 m wide and long, crosses 30 m ahead at 1 m/s from 5 m
   * on the right, turned to the left. The car 26 m behind is faster by 10 m/s.
   */
  private static final String SCENE =
      """
      name: passing
      title: The ego passes a walker and is hit from behind
      duration_s: 5
      ego: {speed_kmh: 36, coasting_deceleration_mps2: 0}
      actors:
        - {kind: pedestrian, name: a walker, gap_m: 30, lateral_offset_m: -5, heading_deg: 90,
           speed_kmh: 3.6, length_m: 0.5, width_m: 0.5}
        - {name: car, gap_m: -34.5, speed_kmh: 72, length_m: 4}
      accept:
        formulas:
          - formula: %s
      """;

  private static Scenario scenario(String formula) {
    String quoted = "\"" + formula.replace("\"", "\\\"") + "\"";
    return Scenario.parse(SourceText.of("s.yaml", SCENE.formatted(quoted)), Bench.carla());
  }

  private static Expectation last(Scenario scenario) {
    return scenario.criteria().get(scenario.criteria().size() - 1);
  }

  private static Outcome judge(String formula) {
    Scenario scenario = scenario(formula);
    Trace trace = new Trace();
    new World(scenario.situation(), trace).advanceTo(5_000_000_000L);
    return last(scenario).judge(trace);
  }

  private static String finding(String formula) {
    DiagnosticException refused = assertThrows(DiagnosticException.class, () -> scenario(formula));
    Diagnostic finding = refused.diagnostics().get(0);
    return finding.id() + ": " + finding.message() + " " + finding.hint();
  }

  /** After 2 s the ego is 10 m before the walker, who is 3 m on the right. */
  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "gap; 10 m",
        "offset; -3 m",
        "ttc; 1 s",
        // the walker's nearest corner is 10 m ahead and 3 - 0.25 - 0.9 m aside of the ego's
        "distance; 10.1696 m"
      })
  void quantitiesAreThoseOfTheScene(String quantity, String value) {
    String difference = "abs(actor('a walker').%s - %s)".formatted(quantity, value);
    String unit = value.replaceAll(".* ", "");
    assertTrue(judge("always[2,2.01] " + difference + " < 0.101 " + unit).passed());
    assertFalse(judge("always[2.1,2.11] " + difference + " < 0.00001 " + unit).passed());
  }

  @Test
  void distanceIsThatOfTheSidesWhereTheyAreBesideEachOther() {
    // After 3.2 s the walker is beside the ego's front: 5 - 3.2 - 0.25 - 0.9 m away.
    assertTrue(
        judge("always[3.2,3.21] abs(actor('a walker').distance - 0.65 m) < 0.011 m").passed());
    assertTrue(judge("always[3.2,3.21] actor('a walker').gap < 0 m").passed());
  }

  @Test
  void nothingIsKnownOfAnActorThatIsGone() {
    assertTrue(judge("always[0,1.9] actor('car').speed > 19 m/s").passed());
    Outcome gone = judge("always[3,4] actor('car').speed > 19 m/s");
    assertFalse(gone.passed());
    assertEquals(false, gone.tested());
  }

  @Test
  void blanksAndQuotesDoNotMatter() {
    assertEquals(
        List.of("actor('a walker').gap"),
        last(scenario("eventually actor ( \"a walker\" ) . gap < 3 m")).signals().stream()
            .map(signal -> signal.name())
            .toList());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "actor('a walkr').gap > 1 m; signal: There is no actor('a walkr').gap here. Did you mean `actor('a walker').gap`?",
        "actor('a walker').gab > 1 m; signal: There is no actor('a walker').gab here. Did you mean `actor('a walker').gap`?",
        "actor(walker).gap > 1 m; syntax: Formulas have no '.'",
      })
  void whatIsNotThereIsNamed(String formula, String expected) {
    String found = finding("always " + formula);
    assertTrue(found.startsWith("scenario.formula." + expected), found);
  }
}

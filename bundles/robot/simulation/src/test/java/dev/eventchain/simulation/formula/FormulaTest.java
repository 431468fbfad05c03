package dev.eventchain.simulation.formula;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.FormulaCriterion;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.States;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests formulas on a run of one second: the speed grows from 0 by 0.1 m/s each sample, and the gap
 * falls from 20 m by 0.1 m. TTC is infinite before 0.5 s and then falls from 2 s by 2 s each
 * second. Full brake is commanded from 0.6 s to 0.8 s.
 */
class FormulaTest {

  private static final double DURATION = 10;
  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private static Trace run() {
    return run(100);
  }

  private static Trace run(int last) {
    Trace trace = new Trace();
    for (int i = 0; i <= last; i++) {
      double timeToCollision = i < 50 ? INFINITE : (200 - 2 * (i - 50)) / 100.0;
      double gap = (200 - i) / 10.0;
      trace.state(States.of(i * World.TRACE_STEP, i / 10.0, gap, timeToCollision, -10));
    }
    command(trace, 0, VehicleCommand.drive(0.25));
    command(trace, 595_000_000L, VehicleCommand.brake(1));
    command(trace, 795_000_000L, VehicleCommand.brake(0));
    return trace;
  }

  private static void command(Trace trace, long time, VehicleCommand command) {
    if (time <= trace.end().time()) {
      trace.command(time, command);
    }
  }

  private static Formula parse(String formula) {
    return Formula.parse(SourceText.of("f", formula).whole(), new WorldSignals(), DURATION);
  }

  private static String judge(String formula, Trace trace) {
    Outcome outcome = parse(formula).judge(trace);
    String verdict = outcome.tested() ? outcome.passed() ? "passed" : "failed" : "untested";
    return verdict + ": " + outcome.detail();
  }

  @ParameterizedTest
  @CsvFileSource(resources = "/formulas/judged.csv", delimiter = ';', numLinesToSkip = 1)
  void verdictAndMarginAreThoseComputedByHand(String formula, String expected) {
    assertEquals(expected, judge(formula, run()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "always ego.speed < 5 m/s; [0.49]",
        "always brake < 0.5; [0.59, 0.8]",
        "always[0.65, 0.7] not brake > 0.5; [0.59, 0.8]",
        "eventually ego.speed > 50 m/s; []",
        "always(gap < 15 m implies brake > 0.5); [0.6]",
      })
  void theNearestTimesAtWhichItIsTheOtherWayRoundAreGiven(String formula, String times) {
    Outcome outcome = parse(formula).judge(run());
    assertFalse(outcome.passed(), outcome::detail);
    assertEquals(times, outcome.otherwise().toString(), outcome::toString);
  }

  /** A formula that a beginning violates fails in the whole run. */
  @ParameterizedTest
  @CsvFileSource(resources = "/formulas/judged.csv", delimiter = ';', numLinesToSkip = 1)
  void noBeginningViolatesWhatDoesNotFail(String formula, String expected) {
    for (int last = 0; last <= 100; last++) {
      if (parse(formula).isViolated(SampledRun.beginning(run(last)))) {
        assertTrue(expected.startsWith("failed"), formula + " up to sample " + last);
      }
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "always ego.speed < 5 m/s; true",
        "always ego.speed < 50 m/s; false",
        "eventually ego.speed > 50 m/s; false",
        "eventually[0, 2] ego.speed > 50 m/s; false",
        "eventually[0, 0.5] ego.speed > 50 m/s; true",
        "always[0, 0.4] ego.speed < 5 m/s; false",
        "ego.speed < 1 m/s until brake > 0.5; true",
        "gap > 1 m until brake < -1; false"
      })
  void aBeginningViolatesWhatNothingCanMakeUpFor(String formula, boolean expected) {
    assertEquals(expected, parse(formula).isViolated(SampledRun.beginning(run())), formula);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "always gap > 1 m; untested: nothing ahead",
        "always ttc >= 2 s; untested: nothing ahead",
        "always brake <= 0; untested: no command came",
        "eventually brake > 0; failed: 'brake > 0' is missed by 0 after 0.00 s",
        "eventually gap < 1 m; failed: 'gap < 1 m' is missed by infinity after 0.00 s",
        "always (gap > 1 m or ego.speed < 6 m/s);"
            + " passed: 'ego.speed < 6 m/s' holds by 1 m/s after 0.00 s",
        "always (brake > 0 implies throttle <= 0); untested: 'brake > 0' never came true",
        "always gap - ttc * 1 m/s > 0 m; untested: 'gap - ttc * 1 m/s > 0 m' has no value after 0.00 s"
      })
  void whatSaysNothingIsNotTested(String formula, String expected) {
    Trace empty = new Trace();
    empty.state(States.of(0, 5, INFINITE, INFINITE, 0));
    empty.state(States.of(World.TRACE_STEP, 5, INFINITE, INFINITE, 0));
    assertEquals(expected, judge(formula, empty));
  }

  /** A formula that begins too early says so; one that ends in silence does not. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "always not /lamp.data | '/lamp.data' has no value after 0.00 s, since there was no current"
            + " message on /lamp; the first one came after 0.03 s",
        "always[0.03, 0.6] not /lamp.data | '/lamp.data' has no value after 0.50 s, since there was"
            + " no current message on /lamp",
      })
  void aTopicWithoutAMessageIsNotTested(String formula, String expected) {
    Signal lamp =
        new Signal(
            "/lamp.data",
            "1",
            true,
            "a lamp",
            trace ->
                IntStream.range(0, trace.states().size())
                    .mapToDouble(i -> i < 3 || i >= 50 ? Double.NaN : 0)
                    .toArray(),
            trace -> Optional.empty());
    Signal.Source signals =
        new Signal.Source() {
          @Override
          public Optional<Signal> find(String name) {
            return Optional.of(lamp).filter(each -> each.name().equals(name));
          }

          @Override
          public List<String> names() {
            return List.of(lamp.name());
          }
        };
    Outcome outcome =
        Formula.parse(SourceText.of("f", formula).whole(), signals, DURATION).judge(run());
    assertFalse(outcome.tested(), outcome::detail);
    assertEquals(expected, outcome.detail());
  }

  @Test
  void theInstantOfAnImpactIsTheLastSample() {
    Trace trace = new Trace();
    trace.state(States.of(0, 5, 0.02, 0.004, 0));
    trace.state(States.of(4_000_000L, 5, 0, 0, 0));
    trace.impact(5, "the ego hit something");
    assertEquals(
        "failed: 'gap > 0 m' is missed by 0 m after 0.00 s", judge("always gap > 0 m", trace));
    assertTrue(judge("always[0,0.01] gap >= 0 m", trace).startsWith("passed"));
    assertTrue(judge("always[0,0.02] gap >= 0 m", trace).startsWith("untested"));
  }

  /** An initial speed in km/h equals the same number in a formula, for any value. */
  @Test
  void speedsOfTheScenarioAreThoseOfFormulas() {
    for (int speed = 0; speed <= 250; speed++) {
      Trace trace = new Trace();
      trace.state(States.of(0, speed * (1.0 / 3.6), 1, 1, 0));
      assertEquals(
          "passed: 'ego.speed <= " + speed + " km/h' holds by 0 km/h after 0.00 s",
          judge("always ego.speed <= " + speed + " km/h", trace));
    }
  }

  @ParameterizedTest
  @CsvFileSource(resources = "/formulas/refused.csv", delimiter = ';', numLinesToSkip = 1)
  void problemsAreFoundAtTheirPlaceWithAHint(
      String formula, String id, int column, String message, String hint) {
    DiagnosticException failure = assertThrows(DiagnosticException.class, () -> parse(formula));
    Diagnostic problem = failure.diagnostics().get(0);
    String described = problem.message() + " " + problem.hint();
    assertEquals("scenario.formula." + id, problem.id(), described);
    assertEquals(column, problem.location().column(), described);
    assertTrue(problem.message().contains(message), described);
    assertTrue(problem.hint().contains(hint == null ? "" : hint), described);
  }

  @ParameterizedTest
  @EnumSource
  void theExampleOfEachOperatorHolds(Operator operator) {
    assertTrue(judge(operator.example(), run()).startsWith("passed"), operator.example());
    boolean shown = operator.example().contains(operator.name().toLowerCase(Locale.ROOT));
    assertTrue(shown || !Operator.KEYWORDS.contains(operator.name().toLowerCase(Locale.ROOT)));
  }

  /** A formula is judged at the start: what would look back from there says nothing. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "once brake > 0.5",
        "not historically gap > 1 m",
        "gap > 1 m since brake > 0.5",
        "brake > 0.5 implies once gap > 1 m",
      })
  void nothingIsJudgedBeforeTheStart(String formula) {
    DiagnosticException failure =
        assertThrows(
            DiagnosticException.class,
            () ->
                Formula.parse(
                    SourceText.of("f", formula).whole(),
                    new WorldSignals(),
                    DURATION,
                    signal -> Range.ALL));
    Diagnostic problem = failure.diagnostics().get(0);
    assertEquals("scenario.formula.syntax", problem.id());
    assertTrue(problem.message().startsWith("Nothing comes before the start"), problem::message);
  }

  /** Deeply nested formulas are rejected before they overflow the stack. */
  @ParameterizedTest
  @ValueSource(strings = {"(", "not ", "-", "always ", "abs(", "brake > 0 implies "})
  void formulasNestedTooDeepAreRefused(String opening) {
    assertThrows(DiagnosticException.class, () -> parse(opening.repeat(290) + "gap"));
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> parse(opening.repeat(100_000)));
    assertTrue(failure.getMessage().contains("too long"), failure.getMessage());
  }

  @Test
  void scenarioHasItsFormulasWithTheirPlaces() {
    Scenario scenario =
        Scenario.read(
            Path.of("src/test/resources/formulas/formulas-of-all-kinds.yaml"), Bench.carla());
    List<Expectation> formulas =
        scenario.criteria().stream().filter(FormulaCriterion.class::isInstance).toList();
    assertEquals(
        List.of(
            "13:7 keeps its speed (always[5,30] abs(ego.speed - 13.9 m/s) <= 0.5 m/s)",
            "14:7 always (ttc < 1 s implies eventually[0,0.25] brake >= 0.9)",
            "19:7 brakes once (eventually[0,10] rise(brake > 0))"),
        formulas.stream()
            .map(it -> it.location().toString().replaceFirst("^[^:]*:", "") + " " + it.text())
            .toList());
  }

  @Test
  void criteriaWithNamesOfTheirOwnAreFormulas() {
    Scenario scenario =
        Scenario.read(Path.of("src/test/resources/formulas/named.yaml"), Bench.carla());
    assertEquals(
        List.of(
            "minimal_time_gap_s (always (ego.speed > 1 m/s implies gap / ego.speed >= 1.5 s))",
            "maximal_lane_offset_m (always abs(ego.offset) <= 0.25 m)",
            "ego.speed settles at 80 km/h"
                + " (always[12, 20] abs((ego.speed) - (80 km/h)) <= 2 km/h)",
            "ego.speed overshoots 80 km/h by at most 3 km/h"
                + " ((eventually abs((ego.speed) - (80 km/h)) <= 3 km/h)"
                + " and (always (ego.speed) - (80 km/h) <= 3 km/h))"),
        scenario.criteria().stream()
            .filter(FormulaCriterion.class::isInstance)
            .map(Expectation::text)
            .toList());
    assertEquals(20_000_000_000L, scenario.horizon());
  }
}

package dev.eventchain.simulation.formula;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.world.States;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests comparisons with names on a run of one second: the gear is a text, PARK from 0.1 s, DRIVE
 * from 0.5 s, and an unknown text from 0.9 s; the level is a number, 1 from the start and 25.5, as
 * a float, from 0.5 s.
 */
class NamedValuesTest {

  private static final NamedValues GEARS = NamedValues.ofTexts(List.of("PARK", "DRIVE", "REVERSE"));
  private static final NamedValues LEVELS =
      NamedValues.ofNumbers(
          List.of(
              new NamedValues.Value("LOW", 0),
              new NamedValues.Value("FAULT", 1),
              new NamedValues.Value("FAULT", 25.4)));

  private static final Map<String, Signal> SIGNALS =
      Map.of(
          "/gear.data", signal("/gear.data", "1").withNames(GEARS),
          "/level.data", signal("/level.data", "degC").withNames(LEVELS),
          "/plain.data", signal("/plain.data", "1"));

  private static final Signal.Source SOURCE =
      new Signal.Source() {
        @Override
        public Optional<Signal> find(String name) {
          return Optional.ofNullable(SIGNALS.get(name));
        }

        @Override
        public Collection<String> names() {
          return SIGNALS.keySet();
        }
      };

  private static Signal signal(String name, String unit) {
    return new Signal(
        name,
        unit,
        false,
        "",
        trace -> Signal.held(trace, trace.samples(name), Double.NaN),
        trace -> Optional.empty());
  }

  private static Trace run() {
    Trace trace = new Trace();
    for (int i = 0; i <= 100; i++) {
      trace.state(States.of(i * World.TRACE_STEP, 1, 20, 5, 0));
    }
    List.of("PARK", "DRIVE", "UNHEARD_OF")
        .forEach(
            text ->
                trace.sample(
                    "/gear.data",
                    text.equals("PARK")
                        ? 100_000_000L
                        : text.equals("DRIVE") ? 500_000_000L : 900_000_000L,
                    GEARS.numberOf(text)));
    Signal level = SIGNALS.get("/level.data");
    trace.sample("/level.data", 0, level.dimension().coherent(1));
    trace.sample("/level.data", 500_000_000L, level.dimension().coherent(25.4f));
    return trace;
  }

  @Test
  void numbersThatAreCloseHaveNamesOfTheirOwn() {
    double large = 1e15;
    NamedValues names =
        NamedValues.ofNumbers(
            List.of(
                new NamedValues.Value("FIRST", large),
                new NamedValues.Value("NEXT", large + 1),
                new NamedValues.Value("TENTH", 0.1),
                new NamedValues.Value("MORE", 0.1 + 1e-10)));
    assertEquals(Optional.of("NEXT"), names.nameOf(large + 1));
    assertEquals(Optional.empty(), names.nameOf(large + 2));
    assertEquals(Optional.of("MORE"), names.nameOf(0.1 + 1e-10));
    assertEquals(Optional.of("TENTH"), names.nameOf(0.1f));
    assertFalse(names.isNamed(large, "NEXT"));
    assertFalse(names.isNamed(0.1, "MORE"));
  }

  private static Formula parse(String formula) {
    return Formula.parse(SourceText.of("f", formula).whole(), SOURCE, 1, signal -> Range.ALL);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '`',
      value = {
        "eventually[0.1,1] /gear.data == 'DRIVE'; passed: '/gear.data == 'DRIVE'' holds after 0.50 s",
        "always[0.1,1] /gear.data == 'PARK'; failed: '/gear.data == 'PARK'' is missed after 0.50 s, where it is 'DRIVE'",
        "always[0.1,1] /gear.data != 'DRIVE'; failed: '/gear.data != 'DRIVE'' is missed after 0.50 s",
        "always[0.6,1] /gear.data == \"DRIVE\"; failed: '/gear.data == \"DRIVE\"' is missed after 0.90 s, where it is another text",
        "always[0.1,1] (/gear.data != 'REVERSE'); passed: '/gear.data != 'REVERSE'' holds after 0.10 s, where it is 'PARK'",
        "always[0,1] not /gear.data == 'REVERSE'; `untested: '/gear.data == 'REVERSE'' has no value after 0.00 s, since there was no current message on /gear; the first one came after 0.10 s`",
        "always[0,1] /level.data == 'FAULT'; passed: '/level.data == 'FAULT'' holds after 0.00 s",
        "eventually[0,1] /level.data == 'LOW'; failed: '/level.data == 'LOW'' is missed after 0.00 s, where it is 'FAULT'",
        "eventually[0.1,1] rise(/gear.data == 'DRIVE' and /level.data > 20 degC); passed: '/gear.data == 'DRIVE'' holds after 0.50 s",
        "always[0.1,1] (if /gear.data == 'PARK' then 1 else 2) < 1.5; failed: '(if /gear.data == 'PARK' then 1 else 2) < 1.5' is missed by 0.5 after 0.50 s",
      })
  void valuesAreComparedByTheirNames(String formula, String expected) {
    Outcome outcome = parse(formula).judge(run());
    String verdict = outcome.tested() ? outcome.passed() ? "passed" : "failed" : "untested";
    assertEquals(expected, verdict + ": " + outcome.detail());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '~',
      value = {
        "always /gear.data == 'DRIVES'; signal; 22; '/gear.data' is never 'DRIVES'.; Did you mean `DRIVE`?",
        "always /plain.data == 'DRIVE'; signal; 23; No value of '/plain.data' has a name.; Names come from a catalogue or from constants of its message. Compare it with a number.",
        "always /gear.data > 1; syntax; 8; '/gear.data' is a text, and only compared with names of its values.; Write, for example, `/gear.data == 'PARK'`.",
        "always /level.data == 1 degC; syntax; 20; '/level.data' is only equal to names of its values.; Write, for example, `/level.data == 'LOW'`.",
        "always /gear.data = 'PARK'; syntax; 19; Names are not compared by '='.; Write `==`.",
        "always 'PARK' == /gear.data; syntax; 8; Expected a quantity or a condition, but found 'PARK'.; Names of values stand after a signal and `==` or `!=`.",
        "always /plain.data == 1; syntax; 20; Measured quantities are hardly ever equal, so there is no '=='.; Allow a tolerance: `abs(a - b) <= 0.1 m`.",
        "always /gear.data == 'PARK' + 1; syntax; 8; '/gear.data == 'PARK'' is true or false, not a quantity.;",
        "always /gear.data == 'PARK; syntax; 22; Formulas have no '''.;",
        "always not (/gear.data == 'PARK' and /gear.data == 'DRIVE'); constant; 1; 'always not (/gear.data == 'PARK' and /gear.data == 'DRIVE')' is true in every run.; Leave out what makes it so, or say what could be otherwise.",
      })
  void refusedWithAPlaceAndAHint(
      String formula, String id, int column, String message, String hint) {
    Diagnostic found =
        assertThrows(DiagnosticException.class, () -> parse(formula)).diagnostics().get(0);
    assertEquals("scenario.formula." + id, found.id(), found::toString);
    assertEquals(column, found.location().column(), found::toString);
    assertEquals(message, found.message());
    assertEquals(hint == null ? "" : hint, found.hint());
  }

  @Test
  void oneOfAllKnownTextsIsNotTrueInEveryRun() {
    parse("always (/gear.data == 'PARK' or /gear.data == 'DRIVE' or /gear.data == 'REVERSE')");
  }
}

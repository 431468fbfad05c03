package dev.eventchain.pipeline.stage;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests which numbers of a requirement have to be quoted: scenario.judges.number. */
class UnjudgedNumbersTest {

  private static final String SCENARIO =
      """
      name: quoting
      title: A quotation
      requirements: [R-1]
      duration_s: 5
      ego:
        speed_kmh: 50
      accept:
        formulas:
          - judges: {R-1: "shall brake within 300 ms"}
            formula: always ego.speed > 1 m/s
      """;

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '~',
      value = {
        "for **0.2 s** or **5** m; '0.2 s', '5** m'",
        "for 2 minutes, 500 milliseconds or 7 kilometers; '2 minutes', '500 milliseconds', '7 kilometers'",
        "from 30-50 km/h, 1.5 s/2 s, 9 m/s\u00b2* or 1 m/s^2; '50 km/h', '1.5 s', '2 s', '9 m/s\u00b2', '1 m/s^2'",
        "at -40 \u00b0C, 50 % and <6 s; '-40 \u00b0C', '50 %', '6 s'",
        "at 12:30 h, on 2026-11-29, within 2 lanes, in 1 in 3 cases; ~~",
        "by ISO 15622 B, ISO 26262-6 B, R-4 m, v2.0 s and a 2d grid; ~~",
        "and stop within 300 ms; '300 ms'"
      })
  void numbersWithUnitsAreLookedForInTheWordsThatNothingQuotes(String words, String expected) {
    WrittenRequirement requirement =
        new WrittenRequirement(
            "R-1", "The system shall brake within 300 ms " + words + ".", SourceLocation.NONE);
    Scenario scenario = Scenario.parse(SourceText.of("quoting.yaml", SCENARIO), Bench.carla());
    List<String> found =
        UnjudgedNumbers.check(List.of(scenario), List.of(requirement)).stream()
            .map(Diagnostic::message)
            .toList();
    assertEquals(
        expected.isEmpty()
            ? List.of()
            : List.of("No criterion of a scenario judges " + expected + " of R-1."),
        found);
  }
}

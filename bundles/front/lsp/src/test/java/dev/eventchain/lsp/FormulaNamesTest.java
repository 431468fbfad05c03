package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.Hover;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Names of values in formulas of a scenario: what editors propose, and what they say. */
class FormulaNamesTest {

  private static final String SEAT = "/vss/Vehicle/Cabin/Seat/Row2/Middle/OccupancyStatus.data";

  private static Analysis analysis(String marked) {
    return analysis("scenarios/new.yaml", marked);
  }

  private static Analysis analysis(String file, String marked) {
    return UnsavedText.analysis("examples/child-presence/" + file, marked);
  }

  private static String formula(String rest) {
    return "accept:\n  formulas:\n    - formula: always[1, 2] " + SEAT + rest + "\n";
  }

  private static TextPosition cursor(String marked) {
    return new TextLines(marked).position(marked.indexOf('^'));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        " == '^       | == 'OCCUPIED'",
        " == '^'      | == 'OCCUPIED'",
        " == 'OCC^'   | == 'OCCUPIED'",
        " != ^        | != 'OCCUPIED'",
        " == \"OC^    | == \"OCCUPIED\"",
      })
  void namesOfTheSignalAreProposed(String rest, String expected) {
    String marked = formula(" " + rest);
    Completion taken =
        analysis(marked).completions(cursor(marked)).stream()
            .filter(each -> each.label().equals("OCCUPIED"))
            .findFirst()
            .orElseThrow();
    String text = marked.replace("^", "");
    TextLines lines = new TextLines(text);
    assertEquals(
        formula(" " + expected),
        text.substring(0, lines.offset(taken.replaced().start()))
            + taken.insertText()
            + text.substring(lines.offset(taken.replaced().end())));
  }

  /** A name without quotation marks has no blank in it. */
  @Test
  void nothingIsProposedBehindAComparison() {
    String marked = formula(" == 1 and /b^");
    assertTrue(
        analysis(marked).completions(cursor(marked)).stream()
            .noneMatch(each -> each.label().equals("OCCUPIED")));
  }

  @Test
  void anUnknownSignalHasNone() {
    String marked = "accept:\n  formulas:\n    - formula: always /a.data == '^'\n";
    assertEquals(List.of(), analysis(marked).completions(cursor(marked)));
  }

  @Test
  void theSignalIsDescribedByTheNamesOfItsValues() {
    String marked = formula(" == 'OCCUPIED'").replace("Middle", "Mid^dle");
    Optional<Hover> hover = analysis(marked).hover(cursor(marked));
    assertTrue(
        hover.orElseThrow().markdown().contains("`OCCUPIED`, `EMPTY`")
            || hover.orElseThrow().markdown().contains("`EMPTY`, `OCCUPIED`"),
        () -> hover.orElseThrow().markdown());
  }

  /** A catalogue has more topics than anybody reads: they are proposed step by step. */
  @ParameterizedTest
  @CsvSource({
    "/v^, /vss/",
    "/vss/Vehicle/Cabin/Se^, /vss/Vehicle/Cabin/Seat/",
    "/vss/Vehicle/Sp^, /vss/Vehicle/Speed.data"
  })
  void manyTopicsAreProposedByTheirNextStep(String begun, String expected) {
    String marked = "accept:\n  formulas:\n    - formula: always " + begun + "\n";
    List<String> found =
        analysis(marked).completions(cursor(marked)).stream().map(Completion::label).toList();
    assertTrue(found.contains(expected), found.toString());
    assertTrue(found.size() < 200, found.size() + " proposals");
  }

  private static final String SPEED = "/vss/Vehicle/Speed.data";

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '~',
      value = {
        "formula: >\\n        alw^                                 ; always",
        "formula: >-\\n        always\\n\\n        ego.sp^          ; ego.speed",
        "formula: |  # a\\n        always (ttc > 1 s and\\n          ^ ; ego.speed",
        "formula: >\\n        always\\n        /vss/Vehicle/Sp^   ; /vss/Vehicle/Speed.data",
        "formula: >\\n        always SEAT == '^'                 ; OCCUPIED",
        "formula: >\\n        always SEAT ==\\n          'OCC^'    ; OCCUPIED",
      })
  void aFormulaOverSeveralLinesHasTheWordsOfOne(String written, String expected) {
    String marked = formulas(written.replace("\\n", "\n").replace("SEAT", SEAT));
    List<Completion> found = analysis(marked).completions(cursor(marked));
    assertTrue(
        found.stream().anyMatch(each -> each.label().equals(expected)),
        () -> written + ": " + found.stream().map(Completion::label).toList());
    int line = cursor(marked).line();
    assertTrue(found.stream().allMatch(each -> each.replaced().start().line() == line));
  }

  private static String formulas(String formula) {
    return "accept:\n  formulas:\n    - name: a\n      " + formula + "\n      optional: true\n";
  }

  /** Behind the text, keys go on; a text that is no formula has no words. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "formula: >\n        always\n      op^",
        "formula: >\n        always /a.b ==\n      op^",
        "about: >\n        alw^",
      })
  void otherLinesHaveNone(String written) {
    String marked = formulas(written);
    assertTrue(
        analysis(marked).completions(cursor(marked)).stream()
            .noneMatch(each -> each.label().equals("always") || each.label().contains("OCC")));
  }

  @Test
  void wordsAndSignalsOfSeveralLinesAreDescribedAndLeadToTheirOwners() {
    String word = formulas("formula: >\n        always\n          ego.sp^eed > 1 m/s");
    assertTrue(
        analysis(word).hover(cursor(word)).orElseThrow().markdown().startsWith("in m/s"),
        () -> analysis(word).hover(cursor(word)).orElseThrow().markdown());
    String signal =
        formulas("formula: |\n        always\n          " + SPEED.replace("Speed", "Sp^eed"));
    assertTrue(analysis(signal).hover(cursor(signal)).isPresent());
    assertEquals(1, analysis(signal).definitions(cursor(signal)).size());
    String other = formulas("about: >\n        it is al^ways true");
    assertEquals(Optional.empty(), analysis(other).hover(cursor(other)));
  }

  @Test
  void aSourceOfABenchMayTakeSeveralLines() {
    String marked =
        "provides:\n  /a:\n    rate_hz: 10\n    fields:\n      data: >\n        min(ego.sp^, 1)\n";
    List<String> found =
        analysis("bench.yaml", marked).completions(cursor(marked)).stream()
            .map(Completion::label)
            .toList();
    assertTrue(found.contains("ego.speed"), found.toString());
  }

  /** Units behind a number: those of what it is compared with come first. */
  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "always ego.speed > 13 ^; m/s; km/h",
        "always SPEED > 13 ^; km/h; m/s",
        "always ttc < 4 s implies ego.speed > 3m^; m/s; km/h",
        "always abs(ego.acceleration + 4 m/s2) <= 1.5e-1 m/^; m/s2; m",
        "always[0, 2 ^; s; ms",
        "always[0, 2 s] gap > 4 ^; m; km",
        "always 3 ^; m; %",
      })
  void unitsAreProposedBehindNumbers(String formula, String first, String later) {
    String marked = formulas("formula: " + formula.replace("SPEED", SPEED));
    List<Completion> found = analysis(marked).completions(cursor(marked));
    List<String> labels = found.stream().map(Completion::label).toList();
    assertEquals(first, labels.get(0));
    assertTrue(labels.contains(later), labels.toString());
    TextLines lines = new TextLines(marked.replace("^", ""));
    int start = lines.offset(found.get(0).replaced().start());
    String before = marked.substring(0, start);
    assertTrue(before.matches("(?s).*\\d ?"), before);
    assertTrue(
        found.stream()
            .filter(each -> each.label().equals("min"))
            .allMatch(each -> each.kind() == ElementKind.KEYWORD),
        "a function in formulas");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "scenarios/a.yaml; formula: always ego.speed ^",
        "scenarios/a.yaml; formula: always ego.speed > 3^",
        "scenarios/a.yaml; formula: always ego.speed > 3 m/s ^",
        "scenarios/a.yaml; title: 3 ^",
        "campaigns/a.yaml; formula: 3 ^",
      })
  void noUnitsAreProposedElsewhere(String file, String written) {
    String marked = formulas(written);
    assertTrue(
        analysis(file, marked).completions(cursor(marked)).stream()
            .noneMatch(each -> each.label().equals("km/h")));
  }

  @Test
  void numbersOfABenchHaveTheUnitsOfTheirField() {
    String marked =
        "provides:\n  /vss/Vehicle/Speed:\n    rate_hz: 10\n    fields:\n      data: max(1 ^\n";
    assertEquals("km/h", analysis("bench.yaml", marked).completions(cursor(marked)).get(0).label());
  }
}

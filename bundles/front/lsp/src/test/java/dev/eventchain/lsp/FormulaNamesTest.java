package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.Hover;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.Workspace;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.lsp.project.ProjectLanguageService;
import dev.eventchain.lsp.text.OpenTexts;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Names of values in formulas of a scenario: what editors propose, and what they say. */
class FormulaNamesTest {

  private static final String SEAT = "/vss/Vehicle/Cabin/Seat/Row2/Middle/OccupancyStatus.data";

  /** A workspace with one text, which is not saved. */
  private record OnlyText(Path opened, String text) implements Workspace {
    @Override
    public List<Path> files() {
      return List.of();
    }

    @Override
    public Optional<SourceText> text(Path file) {
      return Optional.of(
          file.equals(opened) ? SourceText.of(file.toString(), text) : SourceText.read(file));
    }

    @Override
    public List<EPackage> metamodels(Path file) {
      return List.of();
    }
  }

  private static Analysis analysis(String marked) {
    return analysis("scenarios/new.yaml", marked);
  }

  private static Analysis analysis(String file, String marked) {
    Path opened =
        Repository.ROOT
            .toAbsolutePath()
            .normalize()
            .resolve("examples/child-presence")
            .resolve(file);
    OnlyText only = new OnlyText(opened, marked.replace("^", ""));
    return new ProjectLanguageService(only, new OpenTexts()).analysis(opened).orElseThrow();
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
}

package dev.eventchain.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.ValueSource;

class DocumentTest {

  private static final DocumentRules IDS =
      new DocumentRules(
          Rule.error("a.syntax"),
          Rule.error("a.duplicate"),
          Rule.error("a.type"),
          Rule.error("a.missing"),
          Rule.error("a.unknown"),
          Rule.error("a.range"));

  private final List<Diagnostic> found = new ArrayList<>();

  /** Reads each kind of value from the key of that name. */
  private void readAll(String text, DocumentFormat format) {
    try {
      Document document = Document.parse(SourceText.of("file", text), format, IDS, found::add);
      document.object("", found::add).ifPresent(DocumentTest::readAll);
    } catch (DiagnosticException e) {
      assertEquals(DiagnosticException.Reason.INPUT, e.reason());
      found.addAll(e.diagnostics());
    }
  }

  private static void readAll(ObjectReader object) {
    object.text("text");
    object.texts("texts");
    object.number("number", NumberRange.above(0));
    object.number("percent", NumberRange.of(0, 100));
    object.wholeNumber("count", NumberRange.atLeast(0));
    object.requireTrue("true");
    object.object("object").ifPresent(DocumentTest::readAll);
    object.objects("objects").forEach(DocumentTest::readAll);
    if (object.has("needs")) {
      object.requiredText("needed");
      object.requiredNumber("size", NumberRange.above(0));
      object.requiredObject("part");
      object.requiredObjects("parts");
    }
    object.refuseOthers();
  }

  @ParameterizedTest(name = "{0} {1}")
  @CsvFileSource(resources = "/mistakes.csv", delimiter = '|', numLinesToSkip = 1)
  void aMistakeIsSaidAtItsPlace(DocumentFormat format, String text, String expected) {
    readAll(text.replace("\\n", "\n"), format);
    String all =
        found.stream()
            .map(
                f ->
                    f.id()
                        + " "
                        + f.location().line()
                        + ":"
                        + f.location().column()
                        + " "
                        + f.message()
                        + (" " + f.hint()).stripTrailing())
            .collect(Collectors.joining(" & "));
    assertEquals(expected, all);
    assertTrue(
        found.stream().noneMatch(f -> f.message().matches(".*(Exception|java\\.|class ).*")));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"text\": \"a\", \"number\": 1.50, \"count\": 12, \"true\": true, \"texts\": [\"\"]}",
        "{\"object\": {\"objects\": [{\"count\": 0}, {}]}, \"text\": null}",
      })
  void whatIsRightIsReadAlikeInBothFormats(String text) {
    readAll(text, DocumentFormat.JSON);
    assertEquals(List.of(), found);
    assertEquals(root(text, DocumentFormat.JSON), root(text, DocumentFormat.YAML));
  }

  @Test
  void plainScalarsAreTheTextThatIsWritten() {
    String text =
        "[yes, No, on, 012, 1:30, 0x1F, 1_000, 2027-03-31, .inf, =, <<, True, '~', -0, +7, 1e3]";
    JsonNode root = root(text, DocumentFormat.YAML);
    List<String> read = new ArrayList<>();
    root.forEach(node -> read.add(node.getNodeType().name().charAt(0) + node.asText()));
    assertEquals(
        "Syes SNo Son S012 S1:30 S0x1F S1_000 S2027-03-31 S.inf S= S<< STrue S~ N0 N7 N1E+3",
        String.join(" ", read));
  }

  @Test
  void placesCountCharactersAsEditorsDo() {
    String yaml = "# \uD83D\uDE97\u00E4\nt: \"\uD83D\uDE97\"\nu: [\uD83D\uDE97, {k: 1}]\n";
    Document document =
        Document.parse(SourceText.of("f", yaml), DocumentFormat.YAML, IDS, found::add);
    assertEquals("f:3:10", document.atKey("/u/1/k").toString());
    assertEquals("f:3:13", document.at("/u/1/k").toString());
    assertEquals("f:3:9", document.at("/u/1/none").toString());
    assertEquals(List.of(), found);
  }

  @Test
  void whatABombWouldMakeOfMemoryIsRefused() {
    StringBuilder bomb = new StringBuilder("a0: &a0 [x, x, x, x, x, x, x, x, x]\n");
    for (int i = 1; i < 30; i++) {
      bomb.append(
          String.format(
              Locale.ROOT,
              "a%d: &a%d [%s*a%d]\n",
              i,
              i,
              String.format(Locale.ROOT, "*a%d, ", i - 1).repeat(8),
              i - 1));
    }
    for (String text : List.of(bomb.toString(), "[".repeat(100_000), "{a: ".repeat(100_000))) {
      DiagnosticException e =
          assertThrows(DiagnosticException.class, () -> root(text, DocumentFormat.YAML));
      assertEquals("a.syntax", e.diagnostics().get(0).id());
    }
    assertThrows(DiagnosticException.class, () -> root("[".repeat(100_000), DocumentFormat.JSON));
    String number = "[" + "9".repeat(1_000_000) + "]";
    assertTrue(root(number, DocumentFormat.YAML).get(0).isTextual());
    assertThrows(DiagnosticException.class, () -> root(number, DocumentFormat.JSON));
  }

  @Test
  void whatModelsAnsweredIsReadWhateverIsInIt() {
    SourceText text = SourceText.of("f", "{\"text\": \"\\u0000\\u001b\"}");
    Document.parseWithAnyText(text, DocumentFormat.JSON, IDS, found::add);
    assertEquals(List.of(), found);
  }

  private JsonNode root(String text, DocumentFormat format) {
    return Document.parse(SourceText.of("f", text), format, IDS, found::add).root();
  }
}

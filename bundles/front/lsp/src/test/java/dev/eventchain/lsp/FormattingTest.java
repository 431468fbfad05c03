package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.fixtures.EditorClient;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.eclipse.lsp4j.DocumentFormattingParams;
import org.eclipse.lsp4j.DocumentRangeFormattingParams;
import org.eclipse.lsp4j.FormattingOptions;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextEdit;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Formatting on behalf of an editor: all of a text, or some of its lines. */
class FormattingTest {

  private static final String RULES =
      "context EventChain\r\ninv A:self.name<>''\r\ninv B: self.name<>null  and\r\ntrue";

  @TempDir private static Path folder;

  private static TestSession session;

  @BeforeAll
  static void open() throws IOException {
    Files.writeString(folder.resolve("eventchain.yaml"), "name: x\n");
    session = new TestSession(folder);
  }

  @AfterAll
  static void close() {
    session.close();
  }

  private static String format(String name, String text, FormattingOptions options) {
    return format(folder.resolve(name), text, options);
  }

  private static String format(Path file, String text, FormattingOptions options) {
    session.client.open(file, text);
    TextDocumentIdentifier document = new TextDocumentIdentifier(EditorClient.uri(file));
    List<? extends TextEdit> edits =
        EditorClient.get(
            session
                .client
                .server()
                .getTextDocumentService()
                .formatting(new DocumentFormattingParams(document, options)));
    session.client.close(file);
    return after(text, edits);
  }

  private static String formatLines(String name, String text, Range range) {
    Path file = folder.resolve(name);
    session.client.open(file, text);
    TextDocumentIdentifier document = new TextDocumentIdentifier(EditorClient.uri(file));
    FormattingOptions options = new FormattingOptions(2, true);
    List<? extends TextEdit> edits =
        EditorClient.get(
            session
                .client
                .server()
                .getTextDocumentService()
                .rangeFormatting(new DocumentRangeFormattingParams(document, options, range)));
    session.client.close(file);
    return after(text, edits);
  }

  private static String after(String text, List<? extends TextEdit> edits) {
    TextLines lines = new TextLines(text);
    List<TextEdit> last = new ArrayList<>(edits);
    last.sort(Comparator.comparingInt((TextEdit each) -> start(lines, each)).reversed());
    StringBuilder result = new StringBuilder(text);
    last.forEach(
        each ->
            result.replace(
                start(lines, each), lines.offset(of(each.getRange().getEnd())), each.getNewText()));
    return result.toString();
  }

  private static int start(TextLines lines, TextEdit edit) {
    return lines.offset(of(edit.getRange().getStart()));
  }

  private static TextPosition of(Position position) {
    return new TextPosition(position.getLine(), position.getCharacter());
  }

  private static Range lines(int first, int after) {
    return new Range(new Position(first, 0), new Position(after, 0));
  }

  @Test
  void rulesAreIndentedAsTheEditorWants() {
    assertEquals(
        """
        context EventChain
        \tinv A: self.name <> ''
        \tinv B: self.name <> null and
        \t\ttrue
        """
            .replace("\n", "\r\n"),
        format("a.ocl", RULES, new FormattingOptions(4, false)));
    assertEquals(
        """
        context EventChain
           inv A: self.name <> ''
           inv B: self.name <> null and
              true
        """
            .replace("\n", "\r\n"),
        format("a.ocl", RULES, new FormattingOptions(3, true)));
  }

  @Test
  void someLinesAreFormattedAndOthersStay() {
    assertEquals(
        RULES.replace("inv A:self.name<>''", "  inv A: self.name <> ''"),
        formatLines("a.ocl", RULES, lines(1, 2)));
    assertEquals(
        RULES.replace("\r\ntrue", "\r\n    true\r\n"),
        formatLines("a.ocl", RULES, new Range(new Position(3, 1), new Position(3, 1))));
  }

  @Test
  void aTextWithAByteOrderMarkKeepsIt() {
    assertEquals(
        "\uFEFFcontext EventChain inv A: true\n",
        format("a.ocl", "\uFEFFcontext  EventChain inv A:true", new FormattingOptions(2, true)));
  }

  @Test
  void unfinishedTextsStay() {
    FormattingOptions options = new FormattingOptions(2, true);
    for (String text : List.of("context A\ninv  B: (self.", "context  A\n  inv B")) {
      assertEquals(text, format("a.ocl", text, options));
    }
    assertEquals("[if (a  = b)]", format("a.mtl", "[if (a  = b)]", options));
    assertEquals("a:  \n   - [b", format("a.yaml", "a:  \n   - [b", options));
  }

  @Test
  void templatesKeepWhatTheyCopy() {
    assertEquals(
        "[module m('http://x')/]\n[template public t(a : A)]\n  x  \n[/template]\n",
        format(
            "a.mtl",
            "[module  m( 'http://x' )/]  \n[template public t(a:A)]\n  x  \n[/template]\n",
            new FormattingOptions(2, true)));
  }

  @Test
  void yamlIsFormattedInProjectsOnly(@TempDir Path elsewhere) {
    FormattingOptions options = new FormattingOptions(2, true);
    String text = "a:   \n    b: 1\n    c:\n    -   d: 2\n        e: 3\n\n\n";
    String expected = "a:\n  b: 1\n  c:\n  - d: 2\n    e: 3\n";
    assertEquals(expected, format("scenarios/a.yaml", text, options));
    assertEquals(text, format(elsewhere.resolve("a.yaml"), text, options));
    assertEquals(text, format("notes.txt", text, options));
  }

  /** One line of a mapping that moves alone is no part of it any more. */
  @Test
  void linesOfYamlThatBelongTogetherMoveTogether() {
    String text = "a:\n    b: 1\n    c: 2  \nd:  \n";
    assertEquals(text, formatLines("a.yaml", text, lines(1, 2)));
    assertEquals("a:\n  b: 1\n  c: 2\nd:  \n", formatLines("a.yaml", text, lines(1, 3)));
    assertEquals(text.replace("d:  ", "d:"), formatLines("a.yaml", text, lines(3, 4)));
  }
}

package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.EditorClient;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.lsp4j.CallHierarchyIncomingCallsParams;
import org.eclipse.lsp4j.CallHierarchyItem;
import org.eclipse.lsp4j.CallHierarchyPrepareParams;
import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.CompletionParams;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DocumentHighlightParams;
import org.eclipse.lsp4j.DocumentSymbolParams;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PrepareRenameParams;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.RenameParams;
import org.eclipse.lsp4j.SemanticTokensParams;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.services.TextDocumentService;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A text of one line with a byte order mark that the editor has kept: each column is one more. */
class MarkTest {

  private static final String TEXT =
      "\uFEFFcontext EventChain def: total : Integer = 1 inv Small: self.total < 9";

  @TempDir private Path folder;

  private static Position at(String text, int more) {
    return new Position(0, TEXT.indexOf(text) + more);
  }

  private static Range word(String text, String word) {
    int start = TEXT.indexOf(text) + text.indexOf(word);
    return new Range(new Position(0, start), new Position(0, start + word.length()));
  }

  @Test
  void answersAndEditsCountTheMark() throws Exception {
    Path file = Files.writeString(folder.resolve("rules.ocl"), TEXT);
    TextDocumentIdentifier document = new TextDocumentIdentifier(EditorClient.uri(file));
    try (TestSession session = new TestSession(folder)) {
      session.client.open(file, TEXT);
      TextDocumentService server = session.client.server().getTextDocumentService();
      Range used = word("self.total", "total");
      Position end = at("self.total", 5);
      assertEquals(used, EditorClient.get(server.hover(new HoverParams(document, end))).getRange());
      PrepareRenameParams prepared = new PrepareRenameParams(document, end);
      assertEquals(used, EditorClient.get(server.prepareRename(prepared)).getSecond().getRange());
      DocumentHighlightParams same = new DocumentHighlightParams(document, end);
      List<Range> both = List.of(word("def: total", "total"), used);
      assertEquals(
          both,
          EditorClient.get(server.documentHighlight(same)).stream()
              .map(each -> each.getRange())
              .toList());
      RenameParams rename = new RenameParams(document, end, "sum");
      assertEquals(
          both,
          EditorClient.get(server.rename(rename)).getChanges().get(document.getUri()).stream()
              .map(TextEdit::getRange)
              .toList());
      assertEquals(
          new Range(at("self.total", 5), at("self.total", 10)),
          replaced(server, new CompletionParams(document, at("self.total", 8))));
    }
  }

  private static Range replaced(TextDocumentService server, CompletionParams asked) {
    return EditorClient.get(server.completion(asked)).getLeft().stream()
        .filter(each -> each.getLabel().startsWith("total"))
        .map(each -> each.getTextEdit().getLeft().getRange())
        .findFirst()
        .orElseThrow();
  }

  @Test
  void outlinesAndCallsCountTheMark() throws Exception {
    Path file = Files.writeString(folder.resolve("rules.ocl"), TEXT);
    TextDocumentIdentifier document = new TextDocumentIdentifier(EditorClient.uri(file));
    try (TestSession session = new TestSession(folder)) {
      session.client.open(file, TEXT);
      TextDocumentService server = session.client.server().getTextDocumentService();
      assertEquals(
          at("context", 0),
          EditorClient.get(server.documentSymbol(new DocumentSymbolParams(document)))
              .get(0)
              .getRight()
              .getRange()
              .getStart());
      assertEquals(
          1,
          EditorClient.get(server.semanticTokensFull(new SemanticTokensParams(document)))
              .getData()
              .get(1));
      CallHierarchyPrepareParams prepared =
          new CallHierarchyPrepareParams(document, at("def: total", 6));
      CallHierarchyItem called = EditorClient.get(server.prepareCallHierarchy(prepared)).get(0);
      assertEquals(word("def: total", "total"), called.getSelectionRange());
      assertEquals(
          List.of(word("self.total", "total")),
          EditorClient.get(
                  server.callHierarchyIncomingCalls(new CallHierarchyIncomingCallsParams(called)))
              .get(0)
              .getFromRanges());
    }
  }

  @Test
  void aChangeForAFindingCountsTheMark() throws Exception {
    String text = TEXT.replace("self.total", "self.totl");
    Path file = Files.writeString(folder.resolve("rules.ocl"), text);
    TextDocumentIdentifier document = new TextDocumentIdentifier(EditorClient.uri(file));
    try (TestSession session = new TestSession(folder)) {
      session.client.open(file, text);
      int start = text.indexOf("totl");
      Diagnostic found =
          session
              .client
              .await(
                  file,
                  each ->
                      !each.isEmpty() && each.get(0).getRange().getStart().getCharacter() == start)
              .get(0);
      CodeActionParams params =
          new CodeActionParams(document, found.getRange(), new CodeActionContext(List.of(found)));
      TextEdit edit =
          EditorClient.get(session.client.server().getTextDocumentService().codeAction(params))
              .get(0)
              .getRight()
              .getEdit()
              .getChanges()
              .get(document.getUri())
              .get(0);
      session.client.change(file, edit.getRange(), edit.getNewText());
      assertTrue(session.client.await(file, List::isEmpty).isEmpty());
    }
  }
}

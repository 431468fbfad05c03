package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.EditorClient;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.lsp4j.CallHierarchyIncomingCallsParams;
import org.eclipse.lsp4j.CallHierarchyItem;
import org.eclipse.lsp4j.CallHierarchyPrepareParams;
import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionParams;
import org.eclipse.lsp4j.DefinitionParams;
import org.eclipse.lsp4j.DocumentHighlightParams;
import org.eclipse.lsp4j.DocumentSymbolParams;
import org.eclipse.lsp4j.FoldingRangeRequestParams;
import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.InlayHintParams;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PrepareRenameParams;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.ReferenceContext;
import org.eclipse.lsp4j.ReferenceParams;
import org.eclipse.lsp4j.RenameParams;
import org.eclipse.lsp4j.SelectionRangeParams;
import org.eclipse.lsp4j.SemanticTokensParams;
import org.eclipse.lsp4j.SignatureHelpParams;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.WorkspaceEdit;
import org.eclipse.lsp4j.WorkspaceSymbolParams;
import org.eclipse.lsp4j.services.TextDocumentService;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Each question of an editor about a document of rules, answered by the protocol. */
class LanguageTest {

  private static final String RULES =
      """
      package eventchain
      context EventChain
      def: total(extra : Integer) : Integer = software->size() + extra
      inv Small: self.total(1) < 100
      inv Named: let n = name in n <> ''
      endpackage
      """;

  @TempDir private static Path folder;

  private static TestSession session;
  private static Path file;
  private static TextDocumentIdentifier document;

  @BeforeAll
  static void open() throws IOException {
    file = Files.writeString(folder.resolve("rules.ocl"), RULES);
    document = new TextDocumentIdentifier(EditorClient.uri(file));
    session = new TestSession(folder);
    session.client.open(file);
  }

  @AfterAll
  static void close() {
    session.close();
  }

  private static TextDocumentService server() {
    return session.client.server().getTextDocumentService();
  }

  private static Position at(String text, int more) {
    int offset = RULES.indexOf(text) + more;
    int line = (int) RULES.substring(0, offset).chars().filter(c -> c == '\n').count();
    return new Position(line, offset - (RULES.lastIndexOf('\n', offset - 1) + 1));
  }

  @Test
  void completesAndDescribes() {
    List<CompletionItem> items =
        EditorClient.get(server().completion(new CompletionParams(document, at("self.", 5))))
            .getLeft();
    assertTrue(items.stream().anyMatch(each -> each.getLabel().startsWith("software")));
    Hover hover = EditorClient.get(server().hover(new HoverParams(document, at("software", 1))));
    assertTrue(hover.getContents().getRight().getValue().contains("SoftwareNode"));
    assertTrue(
        EditorClient.get(server().signatureHelp(new SignatureHelpParams(document, at("l(1)", 2))))
            .getSignatures()
            .get(0)
            .getLabel()
            .startsWith("total("));
  }

  @Test
  void findsDeclarationsAndUses() {
    Location declared =
        EditorClient.get(server().definition(new DefinitionParams(document, at("total(1)", 1))))
            .getLeft()
            .get(0);
    assertEquals(at("total(extra", 0), declared.getRange().getStart());
    ReferenceParams uses =
        new ReferenceParams(document, at("total(extra", 1), new ReferenceContext(true));
    assertEquals(2, EditorClient.get(server().references(uses)).size());
    DocumentHighlightParams same = new DocumentHighlightParams(document, at("total(extra", 1));
    assertEquals(2, EditorClient.get(server().documentHighlight(same)).size());
  }

  @Test
  void renamesOrSaysWhyNot() {
    PrepareRenameParams asked = new PrepareRenameParams(document, at("total(1)", 1));
    assertEquals(
        "total", EditorClient.get(server().prepareRename(asked)).getSecond().getPlaceholder());
    RenameParams rename = new RenameParams(document, at("total(1)", 1), "sum");
    WorkspaceEdit edit = EditorClient.get(server().rename(rename));
    assertEquals(2, edit.getChanges().get(document.getUri()).size());
    RenameParams wrong = new RenameParams(document, at("total(1)", 1), "not a name");
    assertThrows(IllegalStateException.class, () -> EditorClient.get(server().rename(wrong)));
  }

  @Test
  void outlines() {
    assertFalse(
        EditorClient.get(server().documentSymbol(new DocumentSymbolParams(document))).isEmpty());
    assertEquals(
        List.of("Small"),
        EditorClient.get(
                session
                    .client
                    .server()
                    .getWorkspaceService()
                    .symbol(new WorkspaceSymbolParams("SMALL")))
            .getRight()
            .stream()
            .map(each -> each.getName())
            .toList());
    assertFalse(
        EditorClient.get(server().foldingRange(new FoldingRangeRequestParams(document))).isEmpty());
    List<Integer> tokens =
        EditorClient.get(server().semanticTokensFull(new SemanticTokensParams(document))).getData();
    assertEquals(0, tokens.size() % 5);
    assertTrue(tokens.size() > 50);
    Position name = at("name in", 2);
    assertTrue(
        EditorClient.get(server().selectionRange(new SelectionRangeParams(document, List.of(name))))
                .get(0)
                .getParent()
            != null);
    Range all = new Range(new Position(0, 0), new Position(9, 0));
    assertEquals(
        at("n = name", 1),
        EditorClient.get(server().inlayHint(new InlayHintParams(document, all)))
            .get(0)
            .getPosition());
  }

  @Test
  void knowsCallers() {
    CallHierarchyItem called =
        EditorClient.get(
                server()
                    .prepareCallHierarchy(
                        new CallHierarchyPrepareParams(document, at("total(extra", 1))))
            .get(0);
    assertEquals(
        List.of("Small"),
        EditorClient.get(
                server().callHierarchyIncomingCalls(new CallHierarchyIncomingCallsParams(called)))
            .stream()
            .map(call -> call.getFrom().getName())
            .toList());
  }

  @Test
  void knowsTemplates() throws IOException {
    String text =
        """
        [module m('http://eventchain.dev/eventchain/1.0')/]
        [query public twice(s : String) : String = s + s/]
        [template public t(c : EventChain)]
        [twice(c.)/]
        [twice(c.name)/]
        [/template]
        """;
    Path template = folder.resolve("m.mtl");
    session.client.open(template, text);
    TextDocumentIdentifier opened = new TextDocumentIdentifier(EditorClient.uri(template));
    List<CompletionItem> items =
        EditorClient.get(server().completion(new CompletionParams(opened, new Position(3, 9))))
            .getLeft();
    assertTrue(items.stream().anyMatch(each -> each.getLabel().startsWith("software")));
    Location declared =
        EditorClient.get(server().definition(new DefinitionParams(opened, new Position(4, 3))))
            .getLeft()
            .get(0);
    assertEquals(1, declared.getRange().getStart().getLine());
    session.client.close(template);
  }

  @Test
  void knowsNothingOfOtherFiles() {
    TextDocumentIdentifier other = new TextDocumentIdentifier("untitled:1");
    assertTrue(
        EditorClient.get(server().completion(new CompletionParams(other, new Position(0, 0))))
            .getLeft()
            .isEmpty());
  }
}

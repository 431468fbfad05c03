package dev.eventchain.lsp.session;

import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.check.Findings;
import dev.eventchain.lsp.text.OpenText;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.lsp.text.Positions;
import java.nio.file.Path;
import java.util.Set;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.TextDocumentItem;
import org.eclipse.lsp4j.VersionedTextDocumentIdentifier;

/** Notes what the editor opens, changes and closes, and has it checked. */
record TextChanges(OpenTexts texts, Checks checks, Findings findings) {

  void opened(TextDocumentItem item) {
    Positions.path(item.getUri())
        .ifPresent(
            path -> {
              texts.open(new OpenText(item.getUri(), path, item.getVersion(), item.getText()));
              checkAgain(path);
            });
  }

  void changed(DidChangeTextDocumentParams params) {
    VersionedTextDocumentIdentifier document = params.getTextDocument();
    Positions.path(document.getUri())
        .ifPresent(
            path -> {
              texts.change(path, document.getVersion(), params.getContentChanges());
              checks.changed(path);
            });
  }

  void closed(String uri) {
    Positions.path(uri)
        .ifPresent(
            path -> {
              texts.close(path);
              checkAgain(path);
            });
  }

  private void checkAgain(Path path) {
    findings.showAgain(path);
    checks.changedOnDisk(Set.of(path));
    checks.list();
  }
}

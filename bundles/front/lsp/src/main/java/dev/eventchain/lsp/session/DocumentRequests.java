package dev.eventchain.lsp.session;

import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.check.Findings;
import dev.eventchain.lsp.text.OpenText;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.lsp.text.Positions;
import java.util.Set;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.DidCloseTextDocumentParams;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.DidSaveTextDocumentParams;
import org.eclipse.lsp4j.TextDocumentItem;
import org.eclipse.lsp4j.VersionedTextDocumentIdentifier;
import org.eclipse.lsp4j.services.TextDocumentService;

/**
 * What an editor says and asks about texts. Texts that are no files on this machine are ignored.
 */
final class DocumentRequests implements TextDocumentService {

  private final OpenTexts texts;
  private final Checks checks;
  private final Findings findings;

  DocumentRequests(OpenTexts texts, Checks checks, Findings findings) {
    this.texts = texts;
    this.checks = checks;
    this.findings = findings;
  }

  @Override
  public void didOpen(DidOpenTextDocumentParams params) {
    TextDocumentItem item = params.getTextDocument();
    Positions.path(item.getUri())
        .ifPresent(
            path -> {
              texts.open(new OpenText(item.getUri(), path, item.getVersion(), item.getText()));
              findings.showAgain(path);
              checks.changedOnDisk(Set.of(path));
              checks.list();
            });
  }

  @Override
  public void didChange(DidChangeTextDocumentParams params) {
    VersionedTextDocumentIdentifier document = params.getTextDocument();
    Positions.path(document.getUri())
        .ifPresent(
            path -> {
              texts.change(path, document.getVersion(), params.getContentChanges());
              checks.changed(path);
            });
  }

  @Override
  public void didClose(DidCloseTextDocumentParams params) {
    Positions.path(params.getTextDocument().getUri())
        .ifPresent(
            path -> {
              texts.close(path);
              findings.showAgain(path);
              checks.changedOnDisk(Set.of(path));
              checks.list();
            });
  }

  /** Saving changes no text that is read; that there may be a new file is noticed on disk. */
  @Override
  public void didSave(DidSaveTextDocumentParams params) {}
}

package dev.eventchain.lsp.session;

import dev.eventchain.constraints.editing.RuleLanguageService;
import dev.eventchain.diagnostics.RulePage;
import dev.eventchain.lsp.action.FindingActions;
import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.check.Findings;
import dev.eventchain.lsp.check.RulePageFiles;
import dev.eventchain.lsp.check.Settings;
import dev.eventchain.lsp.language.EditorWorkspace;
import dev.eventchain.lsp.language.FileLinks;
import dev.eventchain.lsp.language.Formatting;
import dev.eventchain.lsp.language.Languages;
import dev.eventchain.lsp.project.ProjectLanguageService;
import dev.eventchain.lsp.project.ProjectLenses;
import dev.eventchain.lsp.text.Edits;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.lsp.text.Positions;
import dev.eventchain.lsp.text.ProtocolJson;
import dev.eventchain.m2t.editing.TemplateLanguageService;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.IntConsumer;
import org.eclipse.lsp4j.DidChangeWatchedFilesRegistrationOptions;
import org.eclipse.lsp4j.FileSystemWatcher;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializeResult;
import org.eclipse.lsp4j.InitializedParams;
import org.eclipse.lsp4j.MessageParams;
import org.eclipse.lsp4j.MessageType;
import org.eclipse.lsp4j.Registration;
import org.eclipse.lsp4j.RegistrationParams;
import org.eclipse.lsp4j.ServerInfo;
import org.eclipse.lsp4j.ShowDocumentParams;
import org.eclipse.lsp4j.ShowDocumentResult;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.LanguageClientAware;
import org.eclipse.lsp4j.services.LanguageServer;
import org.eclipse.lsp4j.services.TextDocumentService;
import org.eclipse.lsp4j.services.WorkspaceService;

/** The server's side of a session. */
public final class EditorServer implements LanguageServer, LanguageClientAware, AutoCloseable {

  private static final int FINE = 0;
  private static final int NOT_ASKED = 1;

  private final String version;
  private final IntConsumer end;
  private final OpenTexts texts = new OpenTexts();
  private final RulePageFiles pages = new RulePageFiles();
  private final Findings findings;
  private final Checks checks;
  private final Languages languages;
  private final Edits edits = new Edits(texts);
  private final DocumentRequests documents;
  private final WorkspaceRequests workspace;
  private LanguageClient client;
  private CompletableFuture<Void> registered = CompletableFuture.completedFuture(null);
  private boolean watches;
  private boolean showsDocuments;
  private boolean refreshes;
  private boolean isShutDown;

  /**
   * Creates a session that has not begun.
   *
   * @param version that of the program
   * @param end takes the exit code when the session is over
   */
  public EditorServer(String version, IntConsumer end) {
    this.version = version;
    this.end = end;
    this.findings = new Findings(texts, pages, found -> client.publishDiagnostics(found));
    this.checks =
        new Checks(
            texts,
            findings,
            defect -> client.logMessage(new MessageParams(MessageType.Error, defect)));
    EditorWorkspace files = new EditorWorkspace(texts, checks);
    this.languages =
        new Languages(
            List.of(
                new RuleLanguageService(files),
                new TemplateLanguageService(files),
                new ProjectLanguageService(files, texts)),
            texts);
    this.documents =
        new DocumentRequests(
            new TextChanges(texts, checks, findings),
            languages,
            edits,
            new FindingActions(files, findings, edits),
            new ProjectLenses(files, texts),
            new FileLinks(files, checks, edits),
            new Formatting(files, edits));
    this.workspace =
        new WorkspaceRequests(texts, checks, languages, files, edits, this::explain, this::refresh);
  }

  @Override
  public void connect(LanguageClient newClient) {
    client = newClient;
  }

  @Override
  public CompletableFuture<InitializeResult> initialize(InitializeParams params) {
    Optional.ofNullable(params.getProcessId())
        .ifPresent(parent -> ParentWatch.start(parent, () -> end.accept(NOT_ASKED)));
    watches = watches(params);
    edits.setVersioned(takesVersions(params));
    showsDocuments =
        Optional.ofNullable(params.getCapabilities())
            .map(all -> all.getWindow())
            .map(all -> all.getShowDocument())
            .map(all -> all.isSupport())
            .orElse(false);
    refreshes =
        Optional.ofNullable(params.getCapabilities())
            .map(all -> all.getWorkspace())
            .map(all -> all.getCodeLens())
            .map(all -> all.getRefreshSupport())
            .orElse(false);
    workspace.set(
        folders(params),
        Settings.of(ProtocolJson.of(params.getInitializationOptions()), Settings.USUAL));
    ServerInfo info = new ServerInfo("eventchain", version);
    return CompletableFuture.completedFuture(new InitializeResult(Capabilities.all(), info));
  }

  @SuppressWarnings("deprecation") // older editors name one folder only, as an address or a path
  private static List<Path> folders(InitializeParams params) {
    List<String> uris = new ArrayList<>();
    if (params.getWorkspaceFolders() != null) {
      params.getWorkspaceFolders().stream().map(WorkspaceFolder::getUri).forEach(uris::add);
    } else if (params.getRootUri() != null) {
      uris.add(params.getRootUri());
    } else if (params.getRootPath() != null) {
      uris.add(Path.of(params.getRootPath()).toUri().toString());
    }
    return uris.stream().flatMap(uri -> Positions.path(uri).stream()).toList();
  }

  private static boolean watches(InitializeParams params) {
    return Optional.ofNullable(params.getCapabilities())
        .map(all -> all.getWorkspace())
        .map(all -> all.getDidChangeWatchedFiles())
        .map(all -> all.getDynamicRegistration())
        .orElse(false);
  }

  private static boolean takesVersions(InitializeParams params) {
    return Optional.ofNullable(params.getCapabilities())
        .map(all -> all.getWorkspace())
        .map(all -> all.getWorkspaceEdit())
        .map(all -> all.getDocumentChanges())
        .orElse(false);
  }

  /** Begins to check: before, an editor may not be told anything but the answer. */
  @Override
  public void initialized(InitializedParams params) {
    workspace.begin();
    if (watches) {
      FileSystemWatcher all = new FileSystemWatcher(Either.forLeft("**/*"));
      DidChangeWatchedFilesRegistrationOptions options =
          new DidChangeWatchedFilesRegistrationOptions(List.of(all));
      Registration registration =
          new Registration("files", "workspace/didChangeWatchedFiles", options);
      registered =
          client
              .registerCapability(new RegistrationParams(List.of(registration)))
              .exceptionally(
                  refused -> {
                    workspace.watch();
                    return null;
                  });
    } else {
      workspace.watch();
    }
  }

  @Override
  public CompletableFuture<Object> shutdown() {
    isShutDown = true;
    return CompletableFuture.completedFuture(null);
  }

  @Override
  public void exit() {
    end.accept(isShutDown ? FINE : NOT_ASKED);
  }

  @Override
  public TextDocumentService getTextDocumentService() {
    return documents;
  }

  @Override
  public WorkspaceService getWorkspaceService() {
    return workspace;
  }

  /** Asks the editor to ask again for verdicts, if it can. */
  private void refresh() {
    if (refreshes) {
      client.refreshCodeLenses().exceptionally(refused -> null);
    }
  }

  /** Shows the page of a rule, if the editor can, and returns its text. */
  private CompletableFuture<Object> explain(String id) {
    if (showsDocuments) {
      pages
          .of(id)
          .ifPresent(
              page ->
                  client
                      .showDocument(new ShowDocumentParams(page.toUri().toString()))
                      .exceptionally(refused -> new ShowDocumentResult(false)));
    }
    return CompletableFuture.completedFuture(RulePage.of(id).map(RulePage::text).orElse(""));
  }

  /** Ends the work in the background. */
  @Override
  public void close() {
    registered.cancel(true);
    checks.close();
    workspace.close();
    languages.close();
    pages.close();
  }
}

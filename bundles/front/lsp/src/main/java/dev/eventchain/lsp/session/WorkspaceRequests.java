package dev.eventchain.lsp.session;

import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.Workspace;
import dev.eventchain.lsp.action.FindingActions;
import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.check.Settings;
import dev.eventchain.lsp.language.Languages;
import dev.eventchain.lsp.language.Protocol;
import dev.eventchain.lsp.text.Edits;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.lsp.text.Positions;
import dev.eventchain.lsp.text.ProtocolJson;
import dev.eventchain.project.ProjectLayout;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.lsp4j.DidChangeConfigurationParams;
import org.eclipse.lsp4j.DidChangeWatchedFilesParams;
import org.eclipse.lsp4j.DidChangeWorkspaceFoldersParams;
import org.eclipse.lsp4j.ExecuteCommandParams;
import org.eclipse.lsp4j.FileChangeType;
import org.eclipse.lsp4j.FileEvent;
import org.eclipse.lsp4j.SymbolInformation;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.WorkspaceSymbol;
import org.eclipse.lsp4j.WorkspaceSymbolParams;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.services.WorkspaceService;

/** Requests and notifications of an editor about folders and files that are not open. */
final class WorkspaceRequests implements WorkspaceService, AutoCloseable {

  private static final int MOST_SYMBOLS = 1000;

  private final OpenTexts texts;
  private final Checks checks;
  private final Languages languages;
  private final Workspace files;
  private final Edits edits;
  private final Function<String, CompletableFuture<Object>> explain;
  private final Runnable verdicts;
  private final DiskWatch disk;
  private List<Path> folders = List.of();
  private Settings settings = Settings.USUAL;

  WorkspaceRequests(
      OpenTexts texts,
      Checks checks,
      Languages languages,
      Workspace files,
      Edits edits,
      Function<String, CompletableFuture<Object>> explain,
      Runnable verdicts) {
    this.verdicts = verdicts;
    this.explain = explain;
    this.texts = texts;
    this.checks = checks;
    this.languages = languages;
    this.files = files;
    this.edits = edits;
    this.disk = new DiskWatch(checks);
  }

  /** Takes the folders that are checked when the session begins. */
  synchronized void set(List<Path> given, Settings set) {
    folders = List.copyOf(given);
    settings = set;
  }

  /** Checks what is in the folders. */
  synchronized void begin() {
    checks.open(folders, settings);
  }

  /** Looks after files for an editor that does not. */
  void watch() {
    disk.start();
  }

  @Override
  public synchronized void didChangeConfiguration(DidChangeConfigurationParams params) {
    set(folders, Settings.of(ProtocolJson.of(params.getSettings()), settings));
    begin();
  }

  @Override
  public synchronized void didChangeWorkspaceFolders(DidChangeWorkspaceFoldersParams params) {
    List<Path> now = new ArrayList<>(folders);
    now.removeAll(paths(params.getEvent().getRemoved()));
    now.addAll(paths(params.getEvent().getAdded()));
    set(now.stream().distinct().toList(), settings);
    begin();
  }

  private static List<Path> paths(List<WorkspaceFolder> given) {
    return given.stream().flatMap(each -> Positions.path(each.getUri()).stream()).toList();
  }

  /** A text that is open in the editor counts more than its file. */
  @Override
  public void didChangeWatchedFiles(DidChangeWatchedFilesParams params) {
    List<Path> changed = new ArrayList<>();
    List<Path> others = new ArrayList<>();
    for (FileEvent event : params.getChanges()) {
      boolean stays = event.getType() == FileChangeType.Changed;
      Positions.path(event.getUri())
          .filter(path -> !stays || texts.of(path).isEmpty())
          .ifPresent((stays ? changed : others)::add);
    }
    if (Stream.concat(changed.stream(), others.stream())
        .anyMatch(file -> file.endsWith(ProjectLayout.VERDICT))) {
      verdicts.run();
    }
    if (!changed.isEmpty()) {
      checks.changedOnDisk(changed);
    }
    if (!others.isEmpty()) {
      checks.appearedOrGone(others);
    }
  }

  @Override
  public CompletableFuture<
          Either<List<? extends SymbolInformation>, List<? extends WorkspaceSymbol>>>
      symbol(WorkspaceSymbolParams params) {
    String wanted = params.getQuery().toLowerCase(Locale.ROOT);
    return languages.later(
        () ->
            Either.forRight(
                files.files().stream()
                    .flatMap(
                        file ->
                            languages
                                .of(file)
                                .flatMap(service -> service.analysis(file))
                                .map(analysis -> named(analysis.workspaceSymbols(), wanted, file))
                                .orElse(Stream.of()))
                    .limit(MOST_SYMBOLS)
                    .toList()));
  }

  private Stream<WorkspaceSymbol> named(List<Symbol> symbols, String wanted, Path file) {
    return symbols.stream()
        .flatMap(
            each ->
                Stream.concat(
                    each.name().toLowerCase(Locale.ROOT).contains(wanted)
                        ? Stream.of(symbol(each, file))
                        : Stream.of(),
                    named(each.children(), wanted, file)));
  }

  private WorkspaceSymbol symbol(Symbol symbol, Path file) {
    return new WorkspaceSymbol(
        symbol.name(),
        Protocol.symbolKind(symbol.kind()),
        Either.forLeft(edits.location(file, symbol.nameRange())));
  }

  @Override
  public CompletableFuture<Object> executeCommand(ExecuteCommandParams params) {
    boolean known = params.getCommand().equals(FindingActions.EXPLAIN);
    Optional<String> id =
        Stream.ofNullable(params.getArguments())
            .flatMap(List::stream)
            .findFirst()
            .map(each -> ProtocolJson.of(each).asText());
    return known && id.isPresent()
        ? explain.apply(id.get())
        : CompletableFuture.completedFuture(null);
  }

  @Override
  public void close() {
    disk.close();
  }
}

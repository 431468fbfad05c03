package dev.eventchain.lsp.session;

import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.check.Settings;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.lsp.text.Positions;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.lsp4j.DidChangeConfigurationParams;
import org.eclipse.lsp4j.DidChangeWatchedFilesParams;
import org.eclipse.lsp4j.DidChangeWorkspaceFoldersParams;
import org.eclipse.lsp4j.FileChangeType;
import org.eclipse.lsp4j.FileEvent;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.services.WorkspaceService;

/** What an editor says and asks about folders and files that are not open. */
final class WorkspaceRequests implements WorkspaceService, AutoCloseable {

  private final OpenTexts texts;
  private final Checks checks;
  private final DiskWatch disk;
  private List<Path> folders = List.of();
  private Settings settings = Settings.USUAL;

  WorkspaceRequests(OpenTexts texts, Checks checks) {
    this.texts = texts;
    this.checks = checks;
    this.disk = new DiskWatch(checks);
  }

  /** Checks what is in folders. */
  synchronized void begin(List<Path> given, Settings set) {
    folders = List.copyOf(given);
    settings = set;
    checks.open(folders, settings);
  }

  /** Looks after files for an editor that does not. */
  void watch() {
    disk.start();
  }

  @Override
  public synchronized void didChangeConfiguration(DidChangeConfigurationParams params) {
    begin(folders, Settings.of(params.getSettings()));
  }

  @Override
  public synchronized void didChangeWorkspaceFolders(DidChangeWorkspaceFoldersParams params) {
    List<Path> now = new ArrayList<>(folders);
    now.removeAll(paths(params.getEvent().getRemoved()));
    now.addAll(paths(params.getEvent().getAdded()));
    begin(now.stream().distinct().toList(), settings);
  }

  private static List<Path> paths(List<WorkspaceFolder> given) {
    return given.stream().flatMap(each -> Positions.path(each.getUri()).stream()).toList();
  }

  /** What is open in the editor counts more than its file. */
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
    if (!changed.isEmpty()) {
      checks.changedOnDisk(changed);
    }
    if (!others.isEmpty()) {
      checks.appearedOrGone(others);
    }
  }

  @Override
  public void close() {
    disk.close();
  }
}

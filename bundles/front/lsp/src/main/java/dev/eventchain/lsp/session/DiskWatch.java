package dev.eventchain.lsp.session;

import dev.eventchain.editing.FileState;
import dev.eventchain.lsp.check.Checks;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Looks for changes on disk, for editors that do not report them. It looks at the files that were
 * read, also those that were not there, and at the folders in which they are.
 */
final class DiskWatch implements AutoCloseable {

  private static final Duration INTERVAL = Duration.ofSeconds(2);
  private static final Duration LONGEST_CHECK = Duration.ofMinutes(1);

  private final Checks checks;
  private final Thread thread = new Thread(this::work, "disk");
  private final Map<Path, FileState> states = new HashMap<>();

  DiskWatch(Checks checks) {
    this.checks = checks;
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  private void work() {
    try {
      while (true) {
        look();
        Thread.sleep(INTERVAL.toMillis());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void look() {
    List<Path> changed = new ArrayList<>();
    List<Path> others = new ArrayList<>();
    for (Path file : checks.read()) {
      note(file, changed, others);
      Path folder = file.getParent();
      if (folder != null) {
        note(folder, others, others);
      }
    }
    if (!changed.isEmpty()) {
      checks.changedOnDisk(changed);
    }
    if (!others.isEmpty()) {
      checks.appearedOrGone(others);
    }
  }

  private void note(Path file, List<Path> changed, List<Path> others) {
    FileState now = FileState.of(file);
    FileState before = states.put(file, now);
    if (before == null ? isNew(now) : !before.equals(now)) {
      boolean came =
          before == null || before.equals(FileState.MISSING) || now.equals(FileState.MISSING);
      (came ? others : changed).add(file);
    }
  }

  /** Returns whether it may have changed between the check that read it and the first look. */
  private static boolean isNew(FileState state) {
    return state.modified().isAfter(Instant.now().minus(LONGEST_CHECK));
  }

  @Override
  public void close() {
    thread.interrupt();
  }
}

package dev.eventchain.lsp.session;

import dev.eventchain.lsp.check.Checks;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
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
  private final Map<Path, State> states = new HashMap<>();

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
    State now = State.of(file);
    State before = states.put(file, now);
    if (before == null ? now.isNew() : !before.equals(now)) {
      boolean came = before == null || before.equals(State.MISSING) || now.equals(State.MISSING);
      (came ? others : changed).add(file);
    }
  }

  /** Fingerprint that tells versions of a file apart. */
  private record State(Instant modified, long size) {

    static final State MISSING = new State(Instant.EPOCH, -1);

    static State of(Path file) {
      try {
        BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
        return new State(attributes.lastModifiedTime().toInstant(), attributes.size());
      } catch (IOException e) {
        return MISSING;
      }
    }

    /** Returns whether it may have changed between the check that read it and the first look. */
    boolean isNew() {
      return modified.isAfter(Instant.now().minus(LONGEST_CHECK));
    }
  }

  @Override
  public void close() {
    thread.interrupt();
  }
}

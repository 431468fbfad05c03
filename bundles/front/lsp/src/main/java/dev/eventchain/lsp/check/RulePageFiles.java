package dev.eventchain.lsp.check;

import dev.eventchain.diagnostics.RulePage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The pages about rules as files, which an editor opens when people follow the link of a finding.
 * They are temporary: the program carries the pages itself.
 */
public final class RulePageFiles implements AutoCloseable {

  private final Map<String, Optional<Path>> written = new HashMap<>();
  private Path folder;

  /** Returns the page of a rule; empty if there is none, or it cannot be written. */
  public synchronized Optional<Path> of(String id) {
    return written.computeIfAbsent(id, key -> RulePage.of(key).flatMap(this::write));
  }

  private Optional<Path> write(RulePage page) {
    try {
      if (folder == null) {
        folder = Files.createTempDirectory("eventchain-rules");
      }
      return Optional.of(Files.writeString(folder.resolve(page.id() + ".md"), page.text()));
    } catch (IOException e) {
      return Optional.empty(); // the link is missing, and the finding is still there
    }
  }

  /** Deletes the files. */
  @Override
  public synchronized void close() {
    if (folder == null) {
      return;
    }
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.toList()) {
        Files.delete(file);
      }
      Files.delete(folder);
    } catch (IOException | UncheckedIOException e) {
      // The system clears its temporary folder.
      return;
    }
  }
}

package dev.eventchain.simulation;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.sandbox.PythonSources;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.TreeMap;

/** The project's message definitions as the runtime in Python reads them. */
final class MessageFile {

  private static final String NAME = "messages.json";

  private MessageFile() {}

  /**
   * Writes them.
   *
   * @return a file in the user's cache, the same for the same definitions
   * @throws dev.eventchain.diagnostics.DiagnosticException a definition is wrong, or {@code
   *     python.unavailable}: the cache cannot be written
   */
  static Path of(MessageCatalog catalog) {
    TreeMap<String, byte[]> files = new TreeMap<>();
    files.put(NAME, catalog.ownDefinitions().getBytes(StandardCharsets.UTF_8));
    return PythonSources.keep(files).resolve(NAME).toAbsolutePath().normalize();
  }
}

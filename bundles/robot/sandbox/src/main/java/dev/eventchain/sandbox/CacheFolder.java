package dev.eventchain.sandbox;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;

/** Folder of reproducible files: the same folder as in {@code environment.py}. */
final class CacheFolder {

  private CacheFolder() {}

  /** Returns Eventchain's folder in the user's cache (XDG Base Directory Specification). */
  static Path of(Map<String, String> settings) {
    Path configured = Path.of(settings.getOrDefault("XDG_CACHE_HOME", ""));
    if (configured.isAbsolute()) {
      return configured.resolve("eventchain");
    }
    String home = settings.getOrDefault("HOME", System.getProperty("user.home"));
    return Path.of(home, ".cache", "eventchain");
  }

  static DiagnosticException unwritable(Path folder, IOException problem) {
    return new DiagnosticException(
        DiagnosticException.Reason.UNAVAILABLE,
        Diagnostic.of(
                PythonRules.PYTHON_UNAVAILABLE,
                "The cache folder cannot be written: " + SourceText.reason(problem) + ".",
                SourceLocation.of(folder))
            .withHint("Make it writable, or set XDG_CACHE_HOME to a folder that is."));
  }
}

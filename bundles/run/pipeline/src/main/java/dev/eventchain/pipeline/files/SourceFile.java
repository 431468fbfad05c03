package dev.eventchain.pipeline.files;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.AtomicFile;
import dev.eventchain.output.OutputRules;
import java.io.IOException;
import java.nio.file.Path;

/** Files of a project that people edit, and that a command writes because it is asked to. */
public final class SourceFile {

  private SourceFile() {}

  /**
   * Writes a file whole or not at all.
   *
   * @throws DiagnosticException (INPUT) if it cannot be written
   */
  public static void write(Path file, String text) {
    try {
      AtomicFile.write(file, text);
    } catch (IOException e) {
      throw unwritable(file, e);
    }
  }

  /** Returns the failure of a file that cannot be written. */
  public static DiagnosticException unwritable(Path file, IOException e) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(
            OutputRules.OUTPUT_UNWRITABLE,
            "This cannot be written: " + SourceText.reason(e) + ".",
            SourceLocation.of(file)));
  }
}

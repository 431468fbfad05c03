package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.Optional;

/** Findings about files that the system refuses, which is no defect of the program. */
final class FilesFinding {

  private FilesFinding() {}

  /** Returns the finding, if it applies to the failure. */
  static Optional<Diagnostic> in(Throwable problem) {
    for (Throwable cause = problem; cause != null; cause = cause.getCause()) {
      if (cause instanceof IOException refused) {
        return Optional.of(finding(refused));
      }
    }
    return Optional.empty();
  }

  private static Diagnostic finding(IOException refused) {
    boolean named = refused instanceof FileSystemException file && file.getFile() != null;
    return Diagnostic.of(
            PipelineRules.EVENTCHAIN_FILES,
            "A file cannot be used: " + SourceText.reason(refused) + ".",
            named
                ? SourceLocation.of(((FileSystemException) refused).getFile())
                : SourceLocation.NONE)
        .withHint("Check free space and permissions, including those of the temporary folder.");
  }
}

package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.Locale;
import java.util.Optional;

/** Findings about input that needs more memory than the launcher grants, which is no defect. */
final class MemoryFinding {

  private static final long MEBIBYTE = 1L << 20;

  private MemoryFinding() {}

  /** Returns the finding, if an out-of-memory error caused the failure. */
  static Optional<Diagnostic> in(Throwable problem) {
    for (Throwable cause = problem; cause != null; cause = cause.getCause()) {
      if (cause instanceof OutOfMemoryError) {
        return Optional.of(finding());
      }
    }
    return Optional.empty();
  }

  private static Diagnostic finding() {
    return Diagnostic.of(
            PipelineRules.EVENTCHAIN_MEMORY,
            String.format(
                Locale.ROOT,
                "The input needs more memory than the %d MiB that are allowed.",
                Runtime.getRuntime().maxMemory() / MEBIBYTE),
            SourceLocation.NONE)
        .withHint("Allow more: EVENTCHAIN_MEMORY=4g eventchain ...");
  }
}

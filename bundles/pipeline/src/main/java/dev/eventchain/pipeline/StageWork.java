package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.DiagnosticException;

/** What a stage does. */
interface StageWork {

  /**
   * Adds everything that the stage reads, so that it runs again when any of it changes.
   *
   * @param fingerprint already holds the stage's name and the build of the program
   */
  void fingerprint(RunContext run, Fingerprint fingerprint);

  /**
   * Does the work.
   *
   * @throws DiagnosticException if the stage cannot make its result
   */
  StageResult execute(RunContext run);

  /** Whether the stage may be skipped when nothing it reads has changed. */
  default boolean skippable() {
    return true;
  }
}

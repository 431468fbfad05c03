package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/** What a stage does. */
public interface StageWork {

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

  /**
   * What a person's changes of its outputs came to.
   *
   * @param details what the stage made, in a few words, as its outputs are now
   * @param diagnostics what was found in its outputs
   */
  record Checked(String details, List<Diagnostic> diagnostics) {}

  /**
   * Checks the outputs of the stage as a person has left them, in a run that has nothing to do for
   * the stage otherwise. What the stage found in its own version of them says nothing about
   * another.
   *
   * @param editedOutputs relative to the output folder; at least one
   * @return nothing where the later stages check all that can be wrong with them
   * @throws DiagnosticException if they cannot be read
   */
  default Optional<Checked> checkEdited(RunContext run, Collection<String> editedOutputs) {
    return Optional.empty();
  }

  /** Whether the stage may be skipped when nothing it reads has changed. */
  default boolean skippable() {
    return true;
  }
}

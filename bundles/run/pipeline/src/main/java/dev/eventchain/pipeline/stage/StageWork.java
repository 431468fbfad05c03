package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/** The work of a stage. */
public interface StageWork {

  /**
   * Adds the inputs that are known before the stage runs: settings, which files there are, and
   * files that other programs read for it. The files that {@link #execute} reads itself are
   * recorded while it does, and count as inputs, too.
   *
   * @param fingerprint the fingerprint, which already has the stage's name and the program's build
   */
  void fingerprint(RunContext run, Fingerprint fingerprint);

  /**
   * Runs the stage.
   *
   * @throws DiagnosticException if the stage cannot produce its result
   */
  StageResult execute(RunContext run);

  /**
   * The result of checking outputs that a person edited.
   *
   * @param details a short description of the outputs as they are now
   * @param diagnostics the findings in the outputs
   */
  record Checked(String details, List<Diagnostic> diagnostics) {}

  /**
   * Checks the outputs of a skipped stage after a person edited them: the stage's findings in its
   * own version do not apply to another one.
   *
   * @param editedOutputs relative to the output folder; at least one
   * @return empty if the later stages check them completely
   * @throws DiagnosticException if they cannot be read
   */
  default Optional<Checked> checkEdited(RunContext run, Collection<String> editedOutputs) {
    return Optional.empty();
  }

  /** Returns whether the stage may be skipped while its inputs are unchanged. */
  default boolean skippable() {
    return true;
  }
}

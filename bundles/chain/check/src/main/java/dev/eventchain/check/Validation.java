package dev.eventchain.check;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * The result of a validation before suppression. The absence of findings is evidence only for the
 * checks in the coverage.
 *
 * @param coverage the checks that ran
 * @param diagnostics the findings, first about the constraints, then about the models
 */
public record Validation(Coverage coverage, List<Diagnostic> diagnostics) {

  /** Copies the findings. */
  public Validation {
    diagnostics = List.copyOf(diagnostics);
  }
}

package dev.eventchain.check;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * The result of a validation, before anything is suppressed. No finding proves only what the
 * coverage says was checked.
 *
 * @param coverage what was checked
 * @param diagnostics what was found, about the constraints and then about the models
 */
public record Validation(Coverage coverage, List<Diagnostic> diagnostics) {

  /** Copies the list. */
  public Validation {
    diagnostics = List.copyOf(diagnostics);
  }
}

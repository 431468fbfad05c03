package dev.eventchain.check;

import dev.eventchain.constraints.document.ConstraintRules;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
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

  /**
   * Returns the same for callers to whom it is enough that models are instances of their
   * metamodels: where no constraint is about them, that is an information.
   */
  public Validation withoutNeedOfConstraints() {
    List<Diagnostic> found =
        diagnostics.stream()
            .map(each -> each.is(ConstraintRules.NOTHING_EVALUATED) ? formOnly(each) : each)
            .toList();
    return new Validation(coverage, found);
  }

  private static Diagnostic formOnly(Diagnostic nothing) {
    return Diagnostic.of(
            nothing.kind(),
            "Only the form of the models was checked: no constraint is about them.",
            nothing.location())
        .withSeverity(Severity.INFO);
  }
}

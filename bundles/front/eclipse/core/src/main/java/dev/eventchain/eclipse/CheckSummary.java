package dev.eventchain.eclipse;

import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import java.util.Arrays;
import java.util.List;

/**
 * A summary of a validation, for people.
 *
 * @param units number of models, projects, documents and templates to check
 * @param unchecked number of them that were not checked; each has a finding with the reason
 * @param errors number of errors
 * @param warnings number of warnings
 * @param constraints number of evaluations of constraints, contracts and rules of a metamodel
 */
public record CheckSummary(
    int units, long unchecked, long errors, long warnings, long constraints) {

  static CheckSummary of(List<Validation> validations) {
    long evaluated = validations.stream().mapToLong(each -> evaluations(each.coverage())).sum();
    return new CheckSummary(
        validations.size(),
        validations.stream().filter(each -> each.coverage().equals(Coverage.NONE)).count(),
        count(validations, Severity.ERROR),
        count(validations, Severity.WARNING),
        evaluated);
  }

  /** Returns the total number of evaluations. */
  static long evaluations(Coverage coverage) {
    return Arrays.stream(Coverage.Kind.values()).mapToLong(coverage::evaluations).sum();
  }

  private static long count(List<Validation> validations, Severity severity) {
    return validations.stream()
        .flatMap(each -> each.diagnostics().stream())
        .map(Diagnostic::severity)
        .filter(severity::equals)
        .count();
  }

  /** Returns whether nothing was checked, so that the absence of errors proves nothing. */
  public boolean isEmpty() {
    return unchecked == units;
  }

  /** Returns the summary as a sentence for people; unchecked units come first. */
  public String words() {
    if (units == 0) {
      return "There is nothing here that could be checked: no model, no rules and no template.";
    }
    String gap =
        unchecked == 0
            ? ""
            : unchecked + " of " + Coverage.counted(units, "part") + " not checked: ";
    return gap
        + Coverage.counted(errors, "error")
        + ", "
        + Coverage.counted(warnings, "warning")
        + " in "
        + Coverage.counted(units, "part")
        + ", "
        + Coverage.counted(constraints, "evaluation");
  }
}

package dev.eventchain.eclipse;

import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import java.util.Arrays;
import java.util.List;

/**
 * What a validation did, for people.
 *
 * @param units how many models, projects, documents and templates there were to check
 * @param unchecked how many of them were not checked; each has a finding that says why
 * @param errors how many findings are errors
 * @param warnings how many findings are warnings
 * @param constraints how often a constraint, a contract or a rule of a metamodel was evaluated
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

  /** How often anything was evaluated. */
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

  /** Whether nothing at all was checked, so that no errors means nothing. */
  public boolean isEmpty() {
    return unchecked == units;
  }

  /** A sentence for people; that something was not checked is said first. */
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

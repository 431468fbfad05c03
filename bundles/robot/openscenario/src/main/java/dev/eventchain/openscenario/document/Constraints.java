package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.document.ParameterDeclaration.Constraint;
import dev.eventchain.openscenario.vocabulary.DataType;
import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** The constraints on the value of a parameter. */
final class Constraints {

  private final Scope scope;
  private final Findings findings;

  Constraints(Scope scope, Findings findings) {
    this.scope = scope;
    this.findings = findings;
  }

  void check(ParameterDeclaration declared, String value, SourceLocation place) {
    List<List<Constraint>> groups = declared.constraints();
    DataType type = DataType.ofWord(declared.type()).orElseThrow();
    boolean holds = groups.isEmpty();
    for (List<Constraint> group : groups) {
      boolean all = true;
      for (Constraint constraint : group) {
        all &= holds(constraint, type, value);
      }
      holds |= all;
    }
    if (!holds) {
      findings.add(
          DocumentRules.PARAMETER_CONSTRAINT,
          "`" + declared.name() + "` is " + value + ", but has to be " + described(groups) + ".",
          place,
          "Give it another value.");
    }
  }

  /** A constraint without a value of its own is reported, and counts as kept. */
  private boolean holds(Constraint constraint, DataType type, String value) {
    Optional<String> limit =
        scope
            .evaluate(constraint.value(), constraint.location())
            .flatMap(
                text ->
                    AttributeValues.check(type, "value", text, constraint.location(), findings));
    return limit.isEmpty() || holds(constraint.rule(), compare(type, value, limit.get()));
  }

  private static int compare(DataType type, String value, String limit) {
    return type.isNumber()
        ? new BigDecimal(value).compareTo(new BigDecimal(limit))
        : value.compareTo(limit);
  }

  private static boolean holds(String rule, int order) {
    return switch (rule) {
      case "equalTo" -> order == 0;
      case "notEqualTo" -> order != 0;
      case "lessThan" -> order < 0;
      case "lessOrEqual" -> order <= 0;
      case "greaterThan" -> order > 0;
      case "greaterOrEqual" -> order >= 0;
      default -> true; // reported where the structure is checked
    };
  }

  private static String described(List<List<Constraint>> groups) {
    return groups.stream()
        .map(
            group ->
                group.stream()
                    .map(each -> each.rule() + " " + each.value())
                    .collect(Collectors.joining(" and ")))
        .collect(Collectors.joining(", or "));
  }
}

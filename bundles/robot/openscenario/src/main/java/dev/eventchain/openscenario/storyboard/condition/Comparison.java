package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import java.util.OptionalDouble;

/** A rule of the standard. Numbers that differ by less than a billionth are equal. */
enum Comparison {
  EQUAL_TO,
  GREATER_THAN,
  LESS_THAN,
  GREATER_OR_EQUAL,
  LESS_OR_EQUAL,
  NOT_EQUAL_TO;

  private static final double SAME = 1e-9;

  /** Reads the rule of a condition. */
  static Comparison of(ScenarioElement condition) {
    return switch (condition.text("rule")) {
      case "equalTo" -> EQUAL_TO;
      case "greaterThan" -> GREATER_THAN;
      case "lessThan" -> LESS_THAN;
      case "greaterOrEqual" -> GREATER_OR_EQUAL;
      case "lessOrEqual" -> LESS_OR_EQUAL;
      case "notEqualTo" -> NOT_EQUAL_TO;
      default -> throw new IllegalArgumentException(condition.text("rule"));
    };
  }

  /** Returns whether a number compares so with a value. */
  boolean holds(double actual, double value) {
    double difference = actual == value ? 0 : actual - value;
    return holds(Math.abs(difference) <= SAME ? 0 : (int) Math.signum(difference));
  }

  /** Returns likewise of a number that may not be there; then no rule holds. */
  boolean holds(OptionalDouble actual, double value) {
    return actual.isPresent() && holds(actual.getAsDouble(), value);
  }

  /** Returns whether a result of {@code compareTo} is as this rule says. */
  boolean holds(int order) {
    return switch (this) {
      case EQUAL_TO -> order == 0;
      case GREATER_THAN -> order > 0;
      case LESS_THAN -> order < 0;
      case GREATER_OR_EQUAL -> order >= 0;
      case LESS_OR_EQUAL -> order <= 0;
      case NOT_EQUAL_TO -> order != 0;
    };
  }
}

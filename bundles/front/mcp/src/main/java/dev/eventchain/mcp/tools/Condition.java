package dev.eventchain.mcp.tools;

import java.util.Comparator;
import java.util.List;
import java.util.Map;

/** A condition on the cells of a column, and their order. */
record Condition(String column, String relation, Object value) {

  private static final List<String> RELATIONS = List.of("equals", "contains", "least", "most");
  private static final double ROUNDING = 1e-9;

  /**
   * Reads a condition.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if it is none
   */
  static Condition of(Map<?, ?> json) {
    List<String> given = RELATIONS.stream().filter(json::containsKey).toList();
    if (!(json.get("column") instanceof String column) || given.size() != 1 || json.size() != 2) {
      throw wrong();
    }
    Object value = json.get(given.get(0));
    boolean number = given.get(0).equals("least") || given.get(0).equals("most");
    if (value == null || (number && !(value instanceof Number))) {
      throw wrong();
    }
    return new Condition(column, given.get(0), value);
  }

  private static RuntimeException wrong() {
    return Arguments.wrong(
        "A condition is a column and one of equals, contains, least and most.",
        "Such as {\"column\": \"passed\", \"equals\": false}.");
  }

  /** Returns whether a cell fulfils it; an empty cell fulfils none. */
  boolean holds(Object cell) {
    return switch (relation) {
      case "equals" ->
          (cell instanceof Number left && value instanceof Number right)
              ? Double.compare(left.doubleValue(), right.doubleValue()) == 0
              : value.equals(cell);
      case "contains" -> cell != null && cell.toString().contains(value.toString());
      case "least" -> cell instanceof Number number && number.doubleValue() >= bound();
      default -> cell instanceof Number number && number.doubleValue() <= bound();
    };
  }

  private double bound() {
    return ((Number) value).doubleValue();
  }

  /** Returns whether a cell is a number between two others. */
  static boolean isWithin(Object cell, double least, double most) {
    return cell instanceof Number number
        && number.doubleValue() >= least - ROUNDING
        && number.doubleValue() <= most + ROUNDING;
  }

  /** Returns an order of rows: numbers before texts, and rows without a value last. */
  static Comparator<Map<String, Object>> order(String column, boolean descending) {
    Comparator<Object> cells =
        Comparator.comparing(
                (Object cell) -> cell instanceof Number number ? number.doubleValue() : 1 / 0.0)
            .thenComparing(Object::toString);
    return Comparator.comparing(
        row -> row.get(column), Comparator.nullsLast(descending ? cells.reversed() : cells));
  }
}

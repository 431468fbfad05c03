package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.XmlElement;
import dev.eventchain.openscenario.vocabulary.DataType;
import java.util.ArrayList;
import java.util.List;

/**
 * A parameter or a variable as its file declares it.
 *
 * @param type {@code boolean}, {@code dateTime}, {@code double}, {@code int}, {@code string},
 *     {@code unsignedInt} or {@code unsignedShort}
 * @param value the value as it is written, which may be an expression
 * @param constraints groups of which one has to hold; a group holds if all its constraints do
 */
public record ParameterDeclaration(
    String name,
    String type,
    String value,
    List<List<Constraint>> constraints,
    SourceLocation location) {

  /**
   * A comparison that a value has to pass.
   *
   * @param rule {@code equalTo}, {@code notEqualTo}, {@code lessThan}, {@code lessOrEqual}, {@code
   *     greaterThan} or {@code greaterOrEqual}
   * @param value the value on the right side as it is written
   */
  public record Constraint(String rule, String value, SourceLocation location) {}

  /** Copies the constraints. */
  public ParameterDeclaration {
    constraints = constraints.stream().map(List::copyOf).toList();
  }

  /** Returns what the children of an element declare, as far as it is whole. */
  static List<ParameterDeclaration> allOf(XmlElement declarations, String typeAttribute) {
    List<ParameterDeclaration> all = new ArrayList<>();
    for (XmlElement each : declarations.children()) {
      String type =
          each.attribute(typeAttribute).flatMap(DataType::ofWord).map(DataType::word).orElse("");
      if (each.attribute("name").isPresent()
          && each.attribute("value").isPresent()
          && !type.isEmpty()) {
        all.add(
            new ParameterDeclaration(
                each.attribute("name").get(),
                type,
                each.attribute("value").get(),
                constraintsOf(each),
                each.location()));
      }
    }
    return all;
  }

  private static List<List<Constraint>> constraintsOf(XmlElement declaration) {
    return declaration.children("ConstraintGroup").stream()
        .map(
            group ->
                group.children("ValueConstraint").stream()
                    .map(
                        each ->
                            new Constraint(
                                each.attribute("rule").orElse(""),
                                each.attribute("value").orElse(""),
                                each.location()))
                    .toList())
        .toList();
  }
}

package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.vocabulary.AttributeType;
import dev.eventchain.openscenario.vocabulary.DataType;
import dev.eventchain.openscenario.vocabulary.Enumeration;
import dev.eventchain.openscenario.vocabulary.Vocabulary;
import java.util.Map;
import java.util.Optional;

/** Values of attributes against the types of the attributes. */
final class AttributeValues {

  private static final Map<String, DataType> PRIMITIVES =
      Map.of(
          "String", DataType.STRING,
          "Double", DataType.DOUBLE,
          "DoubleOrInfinite", DataType.DOUBLE_OR_INFINITE,
          "Int", DataType.INT,
          "UnsignedInt", DataType.UNSIGNED_INT,
          "UnsignedShort", DataType.UNSIGNED_SHORT,
          "Boolean", DataType.BOOLEAN,
          "DateTime", DataType.DATE_TIME);

  private AttributeValues() {}

  /** Returns the primitive type of an attribute; a text for a word of an enumeration. */
  static DataType typeOf(AttributeType attribute) {
    return PRIMITIVES.getOrDefault(attribute.type(), DataType.STRING);
  }

  /** Returns a value in its latest form; empty if it is not of the type. */
  static Optional<String> latest(AttributeType attribute, String value) {
    return Vocabulary.standard()
        .enumeration(attribute.type())
        .map(words -> words.literal(value.strip()).map(Enumeration.Literal::latest))
        .orElseGet(() -> typeOf(attribute).canonical(value));
  }

  /** Returns a value in its latest form; empty, with a finding, if it is not of the type. */
  static Optional<String> check(
      AttributeType attribute, String value, SourceLocation place, Findings findings) {
    Optional<Enumeration> enumeration = Vocabulary.standard().enumeration(attribute.type());
    if (enumeration.isPresent()) {
      Optional<Enumeration.Literal> literal = enumeration.get().literal(value.strip());
      if (literal.isEmpty()) {
        findings.add(
            DocumentRules.VALUE,
            "`" + value + "` is no value of `" + attribute.name() + "`.",
            place,
            NearestName.hint(value, enumeration.get().words()));
      }
      return literal.map(Enumeration.Literal::latest);
    }
    return check(typeOf(attribute), attribute.name(), value, place, findings);
  }

  /** Returns a value in canonical form likewise. */
  static Optional<String> check(
      DataType type, String name, String value, SourceLocation place, Findings findings) {
    Optional<String> canonical = type.canonical(value);
    if (canonical.isEmpty()) {
      findings.add(
          DocumentRules.VALUE,
          "`" + value + "` is no value of `" + name + "`: it is " + type.description() + ".",
          place,
          hint(type, value));
    }
    return canonical;
  }

  private static String hint(DataType type, String value) {
    boolean number = DataType.DOUBLE.canonical(value).isPresent();
    return type.isWhole() && number ? "Use round, floor or ceil for a fraction." : "";
  }
}

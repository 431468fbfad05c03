package dev.eventchain.jsonmodels;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.documents.Document;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Date;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Converts JSON values into attribute values of exactly the type in the metamodel. */
final class AttributeValues {

  private static final Set<Class<?>> REALS =
      Set.of(double.class, Double.class, float.class, Float.class, BigDecimal.class);
  private static final Map<Class<?>, Integer> INTEGER_BITS =
      Map.of(
          byte.class, 8,
          Byte.class, 8,
          short.class, 16,
          Short.class, 16,
          int.class, 32,
          Integer.class, 32,
          long.class, 64,
          Long.class, 64,
          BigInteger.class, Integer.MAX_VALUE);

  /** Classes whose values EMF reads from text itself, without calling code of the class. */
  private static final Set<Class<?>> FROM_TEXT =
      Set.of(char.class, Character.class, byte[].class, Date.class);

  private static final Set<Class<?>> TRUTH_VALUES = Set.of(boolean.class, Boolean.class);

  private final Document text;
  private final List<Diagnostic> findings;

  AttributeValues(Document text, List<Diagnostic> findings) {
    this.text = text;
    this.findings = findings;
  }

  /**
   * Returns the JSON Schema type of values of a data type: integer, number, boolean or string;
   * empty for types whose values cannot be written.
   */
  static Optional<String> jsonType(EDataType type) {
    Class<?> javaType = type.getInstanceClass();
    if (type instanceof EEnum eEnum) {
      return eEnum.getELiterals().isEmpty() ? Optional.empty() : Optional.of("string");
    }
    if (isText(type)) {
      return Optional.of("string");
    }
    if (REALS.contains(javaType)) {
      return Optional.of("number");
    }
    if (INTEGER_BITS.containsKey(javaType)) {
      return Optional.of("integer");
    }
    if (TRUTH_VALUES.contains(javaType)) {
      return Optional.of("boolean");
    }
    return FROM_TEXT.contains(javaType) ? Optional.of("string") : Optional.empty();
  }

  private static boolean isText(EDataType type) {
    return type.getInstanceClass() == null || type.getInstanceClass() == String.class;
  }

  /** Sets an attribute to a JSON value; {@code null} leaves it unset. */
  void set(EObject object, EAttribute attribute, JsonNode value, String pointer) {
    if (value.isNull()) {
      if (attribute.isRequired()) {
        find(
            InstanceRules.FEATURE_MISSING,
            "'" + attribute.getName() + "' is missing.",
            pointer,
            "");
      }
      return;
    }
    if (!attribute.isMany()) {
      convert(attribute, value, pointer).ifPresent(converted -> object.eSet(attribute, converted));
      return;
    }
    @SuppressWarnings("unchecked") // A many-valued attribute holds a list.
    List<Object> values = (List<Object>) object.eGet(attribute);
    if (!value.isArray()) {
      mismatch(attribute, "an array", value, pointer);
      return;
    }
    for (int i = 0; i < value.size(); i++) {
      String place = Document.below(pointer, i);
      convert(attribute, value.get(i), place)
          .ifPresent(converted -> add(values, converted, attribute, place));
    }
  }

  private void add(List<Object> values, Object value, EAttribute attribute, String pointer) {
    if (attribute.isUnique() && values.contains(value)) {
      find(
          InstanceRules.VALUE_DUPLICATE,
          "'" + attribute.getName() + "' already holds this value.",
          pointer,
          "");
    } else {
      values.add(value);
    }
  }

  private Optional<Object> convert(EAttribute attribute, JsonNode value, String pointer) {
    EDataType type = attribute.getEAttributeType();
    Class<?> javaType = type.getInstanceClass();
    if (type instanceof EEnum eEnum) {
      return literal(attribute, eEnum, value, pointer);
    }
    if (isText(type)) {
      return fromText(attribute, value, pointer);
    }
    if (REALS.contains(javaType)) {
      return real(attribute, value, pointer);
    }
    if (INTEGER_BITS.containsKey(javaType)) {
      return integer(attribute, value, pointer);
    }
    if (TRUTH_VALUES.contains(javaType)) {
      return value.isBoolean()
          ? Optional.of(value.asBoolean())
          : mismatch(attribute, "true or false", value, pointer);
    }
    return fromText(attribute, value, pointer);
  }

  private Optional<Object> literal(EAttribute attribute, EEnum type, JsonNode value, String place) {
    if (!value.isTextual()) {
      return mismatch(attribute, "the name of a literal", value, place);
    }
    EEnumLiteral byName = type.getEEnumLiteral(value.asText());
    EEnumLiteral found = byName == null ? type.getEEnumLiteralByLiteral(value.asText()) : byName;
    if (found == null) {
      List<String> known = type.getELiterals().stream().map(EEnumLiteral::getName).toList();
      find(
          InstanceRules.ENUM_UNKNOWN,
          type.getName() + " has no literal '" + value.asText() + "'.",
          place,
          NearestName.hint(value.asText(), known));
      return Optional.empty();
    }
    return Optional.of(EcoreUtil.createFromString(type, found.getLiteral()));
  }

  private Optional<Object> real(EAttribute attribute, JsonNode value, String pointer) {
    if (!value.isNumber()) {
      return mismatch(attribute, "a number", value, pointer);
    }
    EDataType type = attribute.getEAttributeType();
    Class<?> javaType = type.getInstanceClass();
    boolean isFloat = javaType == float.class || javaType == Float.class;
    boolean finite =
        javaType == BigDecimal.class
            || (isFloat
                ? Float.isFinite((float) value.asDouble())
                : Double.isFinite(value.asDouble()));
    return finite
        ? Optional.of(EcoreUtil.createFromString(type, value.asText()))
        : outOfRange(attribute, value, pointer);
  }

  private Optional<Object> integer(EAttribute attribute, JsonNode value, String pointer) {
    if (!value.isIntegralNumber()) {
      return mismatch(attribute, "a whole number", value, pointer);
    }
    EDataType type = attribute.getEAttributeType();
    int bits = INTEGER_BITS.get(type.getInstanceClass());
    BigInteger number = value.bigIntegerValue();
    return number.bitLength() < bits
        ? Optional.of(EcoreUtil.createFromString(type, number.toString()))
        : outOfRange(attribute, value, pointer);
  }

  /** Converts a text to a value of a string type or another type that is safe to read from text. */
  private Optional<Object> fromText(EAttribute attribute, JsonNode value, String pointer) {
    EDataType type = attribute.getEAttributeType();
    if (!value.isTextual()) {
      return mismatch(attribute, "a string", value, pointer);
    }
    if (isText(type)) {
      return Optional.of(value.asText());
    }
    try {
      if (FROM_TEXT.contains(type.getInstanceClass())) {
        return Optional.of(EcoreUtil.createFromString(type, value.asText()));
      }
    } catch (RuntimeException e) {
      // Not a value of the type: reported below.
    }
    find(
        InstanceRules.VALUE_TYPE,
        "'%s' is not a valid %s for '%s'."
            .formatted(value.asText(), type.getName(), attribute.getName()),
        pointer,
        "");
    return Optional.empty();
  }

  private Optional<Object> outOfRange(EAttribute attribute, JsonNode value, String pointer) {
    find(
        InstanceRules.VALUE_RANGE,
        "%s is out of the range of %s, the type of '%s'."
            .formatted(
                shortened(value), attribute.getEAttributeType().getName(), attribute.getName()),
        pointer,
        "");
    return Optional.empty();
  }

  private Optional<Object> mismatch(
      EAttribute attribute, String wanted, JsonNode value, String pointer) {
    String shown = value.isValueNode() && !value.isNull() ? " " + shortened(value) : "";
    find(
        InstanceRules.VALUE_TYPE,
        "'%s' must be %s, not %s%s."
            .formatted(attribute.getName(), wanted, text.kind(value), shown),
        pointer,
        "");
    return Optional.empty();
  }

  private static String shortened(JsonNode value) {
    String shown = value.toString();
    return shown.length() > 60 ? shown.substring(0, 60) + "..." : shown;
  }

  private void find(Rule rule, String message, String pointer, String hint) {
    findings.add(Diagnostic.of(rule, message, text.at(pointer)).withHint(hint));
  }
}

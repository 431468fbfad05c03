package dev.eventchain.metamodel;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.common.util.BasicDiagnostic;
import org.eclipse.emf.common.util.Diagnostic;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.util.Diagnostician;
import org.eclipse.emf.ecore.util.EObjectValidator;
import org.eclipse.emf.ecore.xml.type.util.XMLTypeValidator;

/** Which values the facets of a data type allow, by EMF's own validator. */
final class DataTypeLimits {

  private static final Map<Integer, String> FACETS =
      Map.of(
          EObjectValidator.DATA_VALUE__VALUE_IN_RANGE, "is out of its range",
          EObjectValidator.DATA_VALUE__LENGTH_IN_RANGE, "has a length that its type does not allow",
          EObjectValidator.DATA_VALUE__TYPE_CORRECT, "is of another type",
          EObjectValidator.DATA_VALUE__VALUE_IN_ENUMERATION, "is none of the values of its type",
          EObjectValidator.DATA_VALUE__MATCHES_PATTERN, "does not match the pattern of its type",
          EObjectValidator.DATA_VALUE__TOTAL_DIGITS_IN_RANGE, "has too many digits",
          EObjectValidator.DATA_VALUE__FRACTION_DIGITS_IN_RANGE,
              "has too many digits after the point");

  /** What EMF calls the findings of its validators: other sources are code of metamodels. */
  private static final String SOURCE = EObjectValidator.DIAGNOSTIC_SOURCE;

  private final Diagnostician validator = new Diagnostician();
  private final Map<Object, Object> context = new HashMap<>();

  DataTypeLimits() {
    context.put(org.eclipse.emf.ecore.EValidator.class, validator);
  }

  /** What is wrong with a value, to be read after it; empty if nothing. */
  Optional<String> fault(EDataType type, Object value) {
    BasicDiagnostic found = new BasicDiagnostic();
    try {
      validator.validate(type, value, found, context);
    } catch (RuntimeException e) {
      return Optional.of("cannot be checked: a limit of its type is broken");
    }
    return found.getChildren().stream().flatMap(child -> words(child).stream()).findFirst();
  }

  private static Optional<String> words(Diagnostic fault) {
    boolean schema = XMLTypeValidator.DIAGNOSTIC_SOURCE.equals(fault.getSource());
    if (!schema && !SOURCE.equals(fault.getSource())) {
      return Optional.empty();
    }
    String facet = FACETS.get(fault.getCode());
    return Optional.of(facet != null ? facet : "is no value of its type");
  }
}

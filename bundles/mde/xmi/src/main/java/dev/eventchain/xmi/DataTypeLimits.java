package dev.eventchain.xmi;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.common.util.BasicDiagnostic;
import org.eclipse.emf.common.util.Diagnostic;
import org.eclipse.emf.common.util.DiagnosticChain;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EValidator;
import org.eclipse.emf.ecore.EValidator.PatternMatcher;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.impl.EValidatorRegistryImpl;
import org.eclipse.emf.ecore.util.Diagnostician;
import org.eclipse.emf.ecore.util.EObjectValidator;
import org.eclipse.emf.ecore.xml.type.XMLTypePackage;
import org.eclipse.emf.ecore.xml.type.util.XMLTypeValidator;

/** Checks values against the facets of their data types with EMF's own validator. */
final class DataTypeLimits {

  private static final Map<Integer, String> FACETS =
      Map.of(
          EObjectValidator.DATA_VALUE__VALUE_IN_RANGE, "is out of its range",
          EObjectValidator.DATA_VALUE__LENGTH_IN_RANGE, "has a length that its type does not allow",
          EObjectValidator.DATA_VALUE__TYPE_CORRECT, "is of another type",
          EObjectValidator.DATA_VALUE__VALUE_IN_ENUMERATION, "is not one of the values of its type",
          EObjectValidator.DATA_VALUE__MATCHES_PATTERN, "does not match the pattern of its type",
          EObjectValidator.DATA_VALUE__TOTAL_DIGITS_IN_RANGE, "has too many digits",
          EObjectValidator.DATA_VALUE__FRACTION_DIGITS_IN_RANGE,
              "has too many digits after the decimal point");

  /** The source of diagnostics of EMF's own validators; others come from code of metamodels. */
  private static final String SOURCE = EObjectValidator.DIAGNOSTIC_SOURCE;

  private final Diagnostician validator;
  private final Map<Object, Object> context = new HashMap<>();
  private final PatternTime time;

  /**
   * Uses the facets of XML Schema's types and of metamodels' types, and no validators that Java
   * code has registered.
   */
  DataTypeLimits(PatternTime time) {
    this.time = time;
    EValidator.Registry registry = new EValidatorRegistryImpl(null);
    registry.put(null, new DynamicTypes());
    registry.put(XMLTypePackage.eINSTANCE, new SchemaTypes());
    validator = new Diagnostician(registry);
    context.put(EValidator.class, validator);
  }

  /** The types of metamodels. */
  private final class DynamicTypes extends EObjectValidator {

    /** The facets and compiled patterns of each type, which EMF would compile for each value. */
    private final Map<EDataType, DynamicEDataTypeValidator> validators = new HashMap<>();

    @Override
    public boolean validate(
        EDataType type, Object value, DiagnosticChain found, Map<Object, Object> context) {
      boolean dynamic = type.isInstance(value) && type.getEPackage() != EcorePackage.eINSTANCE;
      return dynamic
          ? validatorOf(type).validate(type, value, found, context)
          : super.validate(type, value, found, context);
    }

    private DynamicEDataTypeValidator validatorOf(EDataType type) {
      return validators.computeIfAbsent(type, DynamicEDataTypeValidator::new);
    }

    @Override
    protected boolean validatePattern(
        EDataType type,
        Object value,
        PatternMatcher[][] patterns,
        DiagnosticChain found,
        Map<Object, Object> context) {
      return super.validatePattern(type, value, time.watched(patterns), found, context);
    }
  }

  /** The types of XML Schema. */
  private final class SchemaTypes extends XMLTypeValidator {

    @Override
    protected boolean validatePattern(
        EDataType type,
        Object value,
        PatternMatcher[][] patterns,
        DiagnosticChain found,
        Map<Object, Object> context) {
      return super.validatePattern(type, value, time.watched(patterns), found, context);
    }
  }

  /**
   * Returns the fault of a value, in words that follow the value; empty if there is none.
   *
   * @throws PatternTime.SpentException if its patterns take too long
   */
  Optional<String> fault(EDataType type, Object value) {
    BasicDiagnostic found = new BasicDiagnostic();
    time.use(type);
    try {
      validator.validate(type, value, found, context);
    } catch (PatternTime.SpentException e) {
      throw e;
    } catch (RuntimeException | StackOverflowError e) {
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
    return Optional.of(facet != null ? facet : "is not a value of its type");
  }
}

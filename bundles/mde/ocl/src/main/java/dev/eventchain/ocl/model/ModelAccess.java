package dev.eventchain.ocl.model;

import dev.eventchain.ocl.values.CollectionOperations;
import dev.eventchain.ocl.values.Numbers;
import dev.eventchain.ocl.values.Unlimited;
import dev.eventchain.ocl.values.Values;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.Collection;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import org.eclipse.emf.common.util.ECollections;
import org.eclipse.emf.common.util.Enumerator;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.ocl.ecore.AnyType;
import org.eclipse.ocl.ecore.CallOperationAction;
import org.eclipse.ocl.ecore.CollectionType;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.ecore.EcoreEnvironment;
import org.eclipse.ocl.ecore.EcoreEnvironmentFactory;
import org.eclipse.ocl.ecore.EcoreEvaluationEnvironment;
import org.eclipse.ocl.ecore.PrimitiveType;
import org.eclipse.ocl.ecore.SendSignalAction;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.types.TupleType;
import org.eclipse.ocl.util.Tuple;
import org.eclipse.ocl.utilities.UMLReflection;

/**
 * Access to models: features, operations, types of values, tuples. Unlike its superclass, it keeps
 * the order of collections, determines the kind of each feature once, and also calls operations of
 * objects without generated code. Thread-safe.
 */
public final class ModelAccess extends EcoreEvaluationEnvironment {

  /** An operation and the Java class of its receiver. */
  private record Callee(EOperation operation, Class<?> type) {}

  private static final String UML2 = "org.eclipse.uml2.uml.";

  /** Ecore does not say which operations are queries; these are the names of UML2's others. */
  private static final Pattern CHANGES =
      Pattern.compile("(create|apply|unapply|set|unset|add|remove|destroy|define)([A-Z].*)?");

  /** The marker of single values in {@link #kinds}. */
  private static final Object SINGLE = new Object();

  private final UMLReflection<
          EPackage,
          EClassifier,
          EOperation,
          EStructuralFeature,
          EEnumLiteral,
          EParameter,
          EObject,
          CallOperationAction,
          SendSignalAction,
          Constraint>
      types;

  /** Cache of the collection kinds of typed elements. */
  private final Map<ETypedElement, Object> kinds = new ConcurrentHashMap<>();

  /** Cache of methods, since Java compares the names of all methods for each lookup. */
  private final Map<Callee, Optional<Method>> methods = new ConcurrentHashMap<>();

  /** Creates access by the types of an environment. */
  public ModelAccess(EcoreEnvironment environment) {
    super((EcoreEnvironmentFactory) environment.getFactory());
    this.types = environment.getUMLReflection();
  }

  /** Returns the kind of collection that a typed element holds; null for a single value. */
  public CollectionKind kindOf(ETypedElement element) {
    Object known = kinds.get(element);
    if (known == null) {
      known = types.getOCLType(element) instanceof CollectionType type ? type.getKind() : SINGLE;
      kinds.put(element, known);
    }
    return known == SINGLE ? null : (CollectionKind) known;
  }

  @Override
  public Object navigateProperty(
      EStructuralFeature property, java.util.List<?> qualifiers, Object target) {
    if (target instanceof EObject object
        && object.eClass().getFeatureID(property) >= 0
        && !(property.getEType() instanceof org.eclipse.ocl.ecore.VoidType)) {
      return coerceValue(property, object.eGet(property), true);
    }
    return super.navigateProperty(property, qualifiers, target);
  }

  /** Converts a result of Java to a collection of the static type, or to the single value. */
  @Override
  protected Object coerceValue(ETypedElement element, Object value, boolean copy) {
    CollectionKind kind = kindOf(element);
    if (kind != null) {
      boolean foreign = Numbers.isForeign(element.getEType());
      return CollectionOperations.asCollection(kind, foreign ? Values.normal(value) : value);
    }
    if (value instanceof Iterator<?> || !(value instanceof Collection<?> collection)) {
      return Numbers.normal(value);
    }
    return collection.isEmpty() ? null : Numbers.normal(collection.iterator().next());
  }

  @Override
  public boolean isKindOf(Object value, EClassifier type) {
    return isInstance(value, type, false);
  }

  @Override
  public boolean isTypeOf(Object value, EClassifier type) {
    return isInstance(value, type, true);
  }

  /** Tests the type of a value; not by Java class, of which an OCL type has several. */
  private boolean isInstance(Object value, EClassifier type, boolean exactly) {
    Object number = Numbers.normal(value);
    if (number == Unlimited.UNLIMITED || Numbers.isNumber(number)) {
      return isNumberOf(number, types.asOCLType(type), exactly);
    } else if (value instanceof Enumerator && type instanceof EEnum enumeration) {
      return enumeration.getELiterals().stream()
          .anyMatch(literal -> literal == value || literal.getInstance() == value);
    } else if (value instanceof Tuple<?, ?> tuple && type instanceof TupleType<?, ?> parts) {
      return areInstances(tuple, parts, exactly);
    }
    if (value instanceof Collection<?> elements && type instanceof CollectionType collection) {
      return isOfKind(elements, collection.getKind(), exactly)
          && areInstances(elements, collection);
    }
    return exactly ? super.isTypeOf(value, type) : super.isKindOf(value, type);
  }

  /** Returns whether a collection is of a kind; an ordered set counts as a set, too. */
  private static boolean isOfKind(Collection<?> elements, CollectionKind kind, boolean exactly) {
    CollectionKind own = CollectionOperations.kindOf(elements);
    boolean isAlso =
        kind == CollectionKind.COLLECTION_LITERAL
            || (kind == CollectionKind.SET_LITERAL && own == CollectionKind.ORDERED_SET_LITERAL);
    return own == kind || (isAlso && !exactly);
  }

  private boolean areInstances(Collection<?> elements, CollectionType type) {
    EClassifier wanted = type.getElementType();
    return wanted instanceof AnyType
        || elements.stream().allMatch(each -> each == null || isInstance(each, wanted, false));
  }

  /** Returns whether a tuple has exactly the parts of a type, with values of their types. */
  private boolean areInstances(Tuple<?, ?> tuple, TupleType<?, ?> type, boolean exactly) {
    Map<String, Object> values = Values.byName(tuple);
    return values.size() == type.oclProperties().size()
        && type.oclProperties().stream()
            .map(EStructuralFeature.class::cast)
            .allMatch(part -> isPart(values, part, exactly));
  }

  private boolean isPart(Map<String, Object> values, EStructuralFeature part, boolean exactly) {
    Object value = values.get(part.getName());
    return values.containsKey(part.getName())
        && (value == null || isInstance(value, part.getEType(), exactly));
  }

  private static boolean isNumberOf(Object number, EClassifier type, boolean exactly) {
    boolean unlimited = number == Unlimited.UNLIMITED;
    boolean integer = Numbers.isInteger(number);
    String name = type instanceof PrimitiveType primitive ? primitive.getName() : "";
    return switch (name) {
      case PrimitiveType.UNLIMITED_NATURAL_NAME -> unlimited;
      case PrimitiveType.INTEGER_NAME -> integer || (unlimited && !exactly);
      case PrimitiveType.REAL_NAME -> !exactly || !(integer || unlimited);
      default -> !exactly && type instanceof AnyType;
    };
  }

  /** Calls an operation of the metamodel. */
  @Override
  public Object callOperation(EOperation operation, int opcode, Object source, Object[] args) {
    if (source instanceof EObject object && declares(object, operation)) {
      if (changesTheModel(operation)) {
        throw new IllegalStateException(
            "the operation '" + operation.getName() + "' changes the model");
      }
      try {
        Object result = object.eInvoke(operation, ECollections.asEList(args));
        return coerceValue(operation, result, true);
      } catch (InvocationTargetException | UnsupportedOperationException e) {
        if (operation.getEContainingClass().getInstanceClass() == null) {
          throw new IllegalStateException(
              "the operation '" + operation.getName() + "' has no implementation", e);
        }
      }
    }
    if (source == null && opcode <= 0) {
      throw new IllegalArgumentException("it is called on null");
    }
    try {
      return super.callOperation(operation, opcode, source, args);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("it cannot be called", e);
    }
  }

  @Override
  protected Method getJavaMethodFor(EOperation operation, Object receiver) {
    return methods
        .computeIfAbsent(
            new Callee(operation, receiver.getClass()),
            callee -> Optional.ofNullable(super.getJavaMethodFor(operation, receiver)))
        .orElse(null);
  }

  /**
   * Returns whether an operation is one of UML2's that change the model; expressions only ask it,
   * and their values must not depend on the order of evaluation.
   */
  private static boolean changesTheModel(EOperation operation) {
    String owner = String.valueOf(operation.getEContainingClass().getInstanceClassName());
    return owner.startsWith(UML2) && CHANGES.matcher(operation.getName()).matches();
  }

  private static boolean declares(EObject object, EOperation operation) {
    return operation.getEContainingClass() != null
        && object.eClass().getOperationID(operation) >= 0;
  }
}

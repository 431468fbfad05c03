package dev.eventchain.constraints;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Values at and beyond the limits of usual model values. */
final class ExtremeValues {
  /** The lower or upper limit. */
  enum Extreme {
    LOW,
    HIGH
  }

  /** Maximal depth to which nested containments are filled. */
  private static final int DEPTH = 3;

  private ExtremeValues() {}

  /** Returns values for an attribute, the lowest first and the highest last. */
  static List<Object> of(EAttribute attribute) {
    EDataType type = attribute.getEAttributeType();
    if (type instanceof EEnum literals) {
      return literals.getELiterals().stream()
          .<Object>map(literal -> literal.getInstance())
          .toList();
    }
    Class<?> java = type.getInstanceClass();
    List<String> texts = java == null || !type.isSerializable() ? List.of() : texts(java);
    List<Object> values = new ArrayList<>();
    for (String text : texts) {
      values.add(EcoreUtil.createFromString(type, text));
    }
    return values;
  }

  private static List<String> texts(Class<?> type) {
    if (type == boolean.class || type == Boolean.class) {
      return List.of("false", "true");
    }
    if (type == String.class) {
      return List.of("", "x", "a b/\"'[]");
    }
    if (isReal(type)) {
      return List.of("-1.0", "0.0", "0.001", "1.0", "1.0E9");
    }
    if (type == byte.class || type == Byte.class) {
      return List.of("-1", "0", "1", "127");
    }
    if (type == short.class || type == Short.class) {
      return List.of("-1", "0", "1", "32767");
    }
    return isNumber(type) ? List.of("-1", "0", "1", "1000000000") : List.of();
  }

  /** Returns whether the values of a Java type are numbers. */
  static boolean isNumber(Class<?> type) {
    boolean primitive = type.isPrimitive() && type != char.class && type != boolean.class;
    return primitive || Number.class.isAssignableFrom(type);
  }

  /** Returns whether the values of a Java type are numbers with fractions. */
  static boolean isReal(Class<?> type) {
    return type == double.class
        || type == Double.class
        || type == float.class
        || type == Float.class
        || type == BigDecimal.class;
  }

  /**
   * Returns a new object for a containment with every feature at a limit; empty if no class is
   * instantiable.
   */
  static Optional<EObject> filled(EReference reference, Extreme extreme, ModelCopy model) {
    return filled(reference, extreme, model, DEPTH);
  }

  private static Optional<EObject> filled(
      EReference reference, Extreme extreme, ModelCopy model, int depth) {
    return concrete(reference.getEReferenceType())
        .map(
            type -> {
              EObject object = EcoreUtil.create(type);
              for (EStructuralFeature feature : type.getEAllStructuralFeatures()) {
                if (feature.isChangeable() && !feature.isDerived() && !isContainer(feature)) {
                  value(feature, extreme, model, depth).ifPresent(v -> set(object, feature, v));
                }
              }
              return object;
            });
  }

  private static Optional<?> value(
      EStructuralFeature feature, Extreme extreme, ModelCopy model, int depth) {
    if (feature instanceof EAttribute attribute) {
      List<Object> values = of(attribute);
      int index = extreme == Extreme.LOW ? 0 : values.size() - 1;
      return values.isEmpty() ? Optional.empty() : Optional.of(values.get(index));
    }
    EReference reference = (EReference) feature;
    if (reference.isContainment()) {
      return depth > 1 ? filled(reference, extreme, model, depth - 1) : Optional.empty();
    }
    return model.instancesOf(reference.getEReferenceType()).stream().findFirst();
  }

  @SuppressWarnings("unchecked")
  private static void set(EObject object, EStructuralFeature feature, Object value) {
    if (feature.isMany()) {
      ((EList<Object>) object.eGet(feature)).add(value);
    } else {
      object.eSet(feature, value);
    }
  }

  private static boolean isContainer(EStructuralFeature feature) {
    return feature instanceof EReference reference && reference.isContainer();
  }

  private static Optional<EClass> concrete(EClass type) {
    if (!type.isAbstract() && !type.isInterface()) {
      return Optional.of(type);
    }
    for (EClassifier classifier : type.getEPackage().getEClassifiers()) {
      if (classifier instanceof EClass candidate
          && !candidate.isAbstract()
          && !candidate.isInterface()
          && type.isSuperTypeOf(candidate)) {
        return Optional.of(candidate);
      }
    }
    return Optional.empty();
  }
}

package dev.eventchain.xmi;

import java.util.Set;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Texts that Java takes for numbers without a finite value: {@code NaN}, {@code Infinity}, and
 * decimals beyond the largest number. Every comparison with them would be a surprise.
 */
final class NonFiniteNumbers {

  private static final Set<String> JAVA_CLASSES =
      Set.of("double", "float", "java.lang.Double", "java.lang.Float");

  /** How XML Schema writes infinity, which Java does not read. */
  private static final Set<String> SCHEMA_INFINITIES = Set.of("INF", "+INF", "-INF");

  private NonFiniteNumbers() {}

  /** Whether a text would give a feature such a value. */
  static boolean contains(EStructuralFeature feature, String text) {
    String type = feature.getEType().getInstanceClassName();
    if (type == null || !JAVA_CLASSES.contains(type)) {
      return false;
    }
    if (SCHEMA_INFINITIES.contains(text.trim())) {
      return true;
    }
    try {
      boolean isSingle = type.endsWith("loat");
      double value = isSingle ? Float.parseFloat(text) : Double.parseDouble(text);
      return !Double.isFinite(value);
    } catch (NumberFormatException e) {
      return false; // Found when EMF makes the value.
    }
  }
}

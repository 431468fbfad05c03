package dev.eventchain.xmi;

import java.util.Set;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Texts that Java reads as numbers without a finite value: {@code NaN}, {@code Infinity}, and
 * decimals beyond the largest number. Comparisons with them would be misleading.
 */
final class NonFiniteNumbers {

  private static final Set<String> JAVA_CLASSES =
      Set.of("double", "float", "java.lang.Double", "java.lang.Float");

  /** Infinity in XML Schema, which Java does not read. */
  private static final Set<String> SCHEMA_INFINITIES = Set.of("INF", "+INF", "-INF");

  private NonFiniteNumbers() {}

  /** Returns whether a text would give a feature such a value. */
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
      return false; // Reported when EMF creates the value.
    }
  }
}

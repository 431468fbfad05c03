package dev.eventchain.constraints;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Values that are tried for attributes: those at the limits of their types, and the literals of a
 * constraint with values on both sides of them.
 */
final class TriedValues {

  /** Distance from a number, as a part of it, and the smallest one. */
  private static final BigDecimal PART = new BigDecimal("0.001");

  private final List<String> texts = new ArrayList<>();
  private final List<BigDecimal> numbers = new ArrayList<>();
  private final Set<Object> known = new HashSet<>();
  private final Set<EAttribute> present = new HashSet<>();

  /**
   * Creates values for a constraint; a literal number without a finite value is left out.
   *
   * @param model the model whose changes are tried
   */
  TriedValues(OclConstraint constraint, ModelCopy model) {
    for (Object literal : constraint.literals()) {
      if (literal instanceof String text) {
        texts.add(text);
      } else if (literal instanceof Number number && Double.isFinite(number.doubleValue())) {
        numbers.add(new BigDecimal(number.toString()));
      }
    }
    for (EObject object : model.objects()) {
      for (EAttribute attribute : object.eClass().getEAllAttributes()) {
        present.add(attribute);
        known.add(object.eGet(attribute));
      }
    }
  }

  /** Returns the values for an attribute, without repetitions. */
  List<Object> of(EAttribute attribute) {
    EDataType type = attribute.getEAttributeType();
    Set<Object> values = new LinkedHashSet<>(ExtremeValues.of(attribute));
    Class<?> java = type.getInstanceClass();
    if (java == String.class) {
      texts.stream().filter(text -> isPossible(text, attribute)).forEach(values::add);
    } else if (java != null && type.isSerializable() && ExtremeValues.isNumber(java)) {
      boolean real = ExtremeValues.isReal(java);
      numbers.forEach(number -> addAround(number, real, type, values));
    }
    return List.copyOf(values);
  }

  /**
   * Returns whether a text may be the value of an attribute in models like this one: somewhere in
   * the model it is a value, or no object has the attribute yet. A misspelt name is neither.
   */
  private boolean isPossible(String text, EAttribute attribute) {
    return known.contains(text) || !present.contains(attribute);
  }

  /**
   * Returns the literal texts that are no value of the model, if it has objects for each of the
   * attributes: what is compared with them never holds.
   */
  List<String> unknown(Collection<EAttribute> attributes) {
    return texts.stream()
        .filter(text -> attributes.stream().noneMatch(each -> isPossible(text, each)))
        .toList();
  }

  private static void addAround(
      BigDecimal number, boolean real, EDataType type, Set<Object> values) {
    BigDecimal step = real ? number.abs().max(BigDecimal.ONE).multiply(PART) : BigDecimal.ONE;
    for (BigDecimal near : List.of(number, number.subtract(step), number.add(step))) {
      parsed(near, real, type).ifPresent(values::add);
    }
  }

  /** Returns a number as a value of a type; empty if the type has no such value. */
  private static Optional<Object> parsed(BigDecimal number, boolean real, EDataType type) {
    try {
      String text = real ? number.toString() : number.toBigIntegerExact().toString();
      return Optional.of(EcoreUtil.createFromString(type, text));
    } catch (ArithmeticException | IllegalArgumentException e) {
      return Optional.empty();
    }
  }
}

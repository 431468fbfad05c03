package dev.eventchain.ocl;

import dev.eventchain.ocl.values.Values;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.common.util.Enumerator;
import org.eclipse.ocl.expressions.UnlimitedNaturalLiteralExp;
import org.eclipse.ocl.util.Bag;
import org.eclipse.ocl.utilities.PredefinedType;

/**
 * The known differences between Eclipse OCL and the standard. Values of Eclipse OCL are not
 * compared if one of them occurs during the evaluation.
 */
final class StockDifferences {

  static final String FAILING_PART = "exception in a part of a tuple";

  /** The names of the differences; {@code stock-differences.md} has an example of each. */
  static final List<String> NAMES =
      List.of(
          "equal numbers in a set",
          "equal numbers",
          "large numbers",
          "type of what is undefined",
          "type of a large number",
          "type of an enumeration's literal",
          "floor or round beyond 32 bit",
          "toInteger beyond 32 bit",
          "isUnique with an invalid body",
          "isUnique of equal numbers",
          "isUnique of bags",
          "sortedBy numbers of several types",
          "a body without a value beside one that decides",
          "undefined body over a set",
          "no number in a collection",
          "part of a tuple without a value",
          "place in the empty string",
          "the unlimited number beside -1",
          FAILING_PART);

  private StockDifferences() {}

  /** Converts a number to Integer, Long or Double, which Eclipse OCL fully supports. */
  static Object asNumberOfOcl(Object value) {
    if (value instanceof Short || value instanceof Byte) {
      return ((Number) value).intValue();
    } else if (value instanceof Long number && number == number.intValue()) {
      return number.intValue();
    } else if (value instanceof BigInteger number && number.bitLength() < Integer.SIZE) {
      return number.intValue();
    }
    return value instanceof Float number ? Double.valueOf(number.toString()) : value;
  }

  /** Returns the difference of a set with equal numbers, if a value is one. */
  static Optional<String> ofValue(Object value) {
    return when(
        "equal numbers in a set", value instanceof Set<?> && holdsEqualNumbers(List.of(value)));
  }

  static Optional<String> ofCall(int code, Object source, Collection<Object> operands) {
    return switch (code) {
      case PredefinedType.OCL_IS_KIND_OF, PredefinedType.OCL_IS_TYPE_OF ->
          when("type of what is undefined", source == null || source == Values.INVALID)
              .or(() -> when("type of a large number", isLarge(source)))
              .or(() -> when("type of an enumeration's literal", source instanceof Enumerator));
      case PredefinedType.FLOOR, PredefinedType.ROUND ->
          when("floor or round beyond 32 bit", !fitsInt(source));
      case PredefinedType.TO_INTEGER ->
          when(
              "toInteger beyond 32 bit",
              source instanceof String text && text.strip().length() > 9);
      case PredefinedType.COUNT,
          PredefinedType.INDEX_OF,
          PredefinedType.LAST_INDEX_OF,
          PredefinedType.MIN,
          PredefinedType.MAX ->
          when("no number in a collection", numbers(operands).contains(Double.NaN))
              .or(() -> when("place in the empty string", "".equals(source)))
              .or(() -> ofNumbers(operands));
      default -> ofNumbers(operands);
    };
  }

  /** Returns the difference of a tuple part that should be a collection. */
  static Optional<String> ofPart(Object value) {
    return when(
        "part of a tuple without a value",
        value instanceof Collection<?> part
            && part.size() == 1
            && (part.contains(null) || part.contains(Values.INVALID)));
  }

  /** Returns the difference of the unlimited number, which Eclipse OCL stores as -1. */
  static Optional<String> ofUnlimited(boolean occurred, Collection<Object> operands) {
    int unlimited = UnlimitedNaturalLiteralExp.UNLIMITED;
    boolean twice = numbers(operands).stream().filter(each -> each.equals(unlimited)).count() > 1;
    return when("the unlimited number beside -1", occurred && twice);
  }

  static Optional<String> ofNumbers(Collection<Object> operands) {
    return when("large numbers", numbers(operands).stream().anyMatch(StockDifferences::isLarge))
        .or(() -> when("equal numbers", holdsEqualNumbers(operands)));
  }

  static Optional<String> ofLoop(String name, boolean unordered, Collection<Object> bodies) {
    return switch (name) {
      case "exists", "forAll" ->
          when(
              "a body without a value beside one that decides",
              bodies.contains(Values.INVALID) || bodies.contains(null));
      case "one" ->
          when(
              "undefined body over a set",
              unordered && (bodies.contains(Values.INVALID) || bodies.contains(null)));
      case "isUnique" ->
          when("isUnique with an invalid body", bodies.contains(Values.INVALID))
              .or(() -> when("isUnique of bags", bodies.stream().anyMatch(Bag.class::isInstance)))
              .or(() -> when("isUnique of equal numbers", holdsEqualNumbers(bodies)));
      case "sortedBy" ->
          when(
              "sortedBy numbers of several types",
              bodies.stream()
                          .filter(Number.class::isInstance)
                          .map(Object::getClass)
                          .distinct()
                          .count()
                      > 1
                  || holdsEqualNumbers(bodies));
      default -> Optional.empty();
    };
  }

  private static Optional<String> when(String difference, boolean met) {
    if (!NAMES.contains(difference)) {
      throw new IllegalArgumentException(difference);
    }
    return met ? Optional.of(difference) : Optional.empty();
  }

  private static boolean isLarge(Object value) {
    return value instanceof Long || value instanceof BigInteger || value instanceof BigDecimal;
  }

  private static boolean fitsInt(Object value) {
    return value instanceof Integer
        || !(value instanceof Number)
        || (value instanceof Double number && Math.abs(number) < Integer.MAX_VALUE);
  }

  /** Returns whether values contain equal numbers that Java distinguishes. */
  private static boolean holdsEqualNumbers(Collection<?> values) {
    Set<Object> inJava = new HashSet<>();
    Set<Object> inOcl = new HashSet<>();
    for (Object number : numbers(values)) {
      inJava.add(number);
      boolean infinite = number instanceof Double real && !Double.isFinite(real);
      inOcl.add(infinite ? number : new BigDecimal(number.toString()).stripTrailingZeros());
    }
    return inJava.size() != inOcl.size();
  }

  /** Returns the numbers among values, also inside collections. */
  private static List<Object> numbers(Collection<?> values) {
    List<Object> numbers = new ArrayList<>();
    for (Object value : values) {
      if (value instanceof Number) {
        numbers.add(value);
      } else if (value instanceof Collection<?> elements) {
        numbers.addAll(numbers(elements));
      }
    }
    return numbers;
  }
}

package dev.eventchain.workspace.launch;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/** Conditions of elements of launch files: {@code if}, {@code unless}, and what Python adds. */
final class LaunchCondition {

  /** The attributes of an element that say whether it is launched. */
  static final Set<String> ATTRIBUTES = Set.of("if", "unless", "equals", "differs", "to");

  private static final Set<String> TRUE = Set.of("true", "1");
  private static final Set<String> FALSE = Set.of("false", "0");

  private LaunchCondition() {}

  /**
   * Returns whether an element is launched; empty if that is not known, or launch would refuse it.
   *
   * @param text returns the value of an attribute, empty if it is not known
   */
  static Optional<Boolean> holds(LaunchElement element, Function<String, Optional<String>> text) {
    boolean isIf = element.attributes().containsKey("if");
    boolean isUnless = element.attributes().containsKey("unless");
    if (isIf && isUnless) {
      return Optional.empty();
    } else if (isIf) {
      return text.apply("if").flatMap(LaunchCondition::truth);
    } else if (isUnless) {
      return text.apply("unless").flatMap(LaunchCondition::truth).map(it -> !it);
    } else if (element.attributes().containsKey("equals")) {
      return equal(element, text);
    } else if (element.attributes().containsKey("differs")) {
      return equal(element, text).map(it -> !it);
    }
    return Optional.of(true);
  }

  static Optional<Boolean> truth(String text) {
    String plain = text.strip().toLowerCase(Locale.ROOT);
    return TRUE.contains(plain)
        ? Optional.of(true)
        : FALSE.contains(plain) ? Optional.of(false) : Optional.empty();
  }

  private static Optional<Boolean> equal(
      LaunchElement element, Function<String, Optional<String>> text) {
    String attribute = element.attributes().containsKey("equals") ? "equals" : "differs";
    return text.apply(attribute).flatMap(one -> text.apply("to").flatMap(it -> equal(one, it)));
  }

  /**
   * Returns whether texts are equal. One condition compares characters, and another one numbers and
   * Booleans: empty where these differ.
   */
  static Optional<Boolean> equal(String one, String other) {
    if (one.equals(other)) {
      return Optional.of(true);
    }
    boolean isSame =
        one.strip().equalsIgnoreCase(other.strip())
            || (truth(one).isPresent() && truth(one).equals(truth(other)))
            || (isNumber(one) && isNumber(other) && isClose(one, other));
    return isSame ? Optional.empty() : Optional.of(false);
  }

  private static boolean isNumber(String text) {
    return text.strip().matches("[-+]?[0-9]{1,30}(\\.[0-9]*)?([eE][-+]?[0-9]{1,3})?");
  }

  private static boolean isClose(String one, String other) {
    double first = Double.parseDouble(one.strip());
    double second = Double.parseDouble(other.strip());
    return Math.abs(first - second) <= 1e-6 * Math.max(Math.abs(first), Math.abs(second));
  }
}

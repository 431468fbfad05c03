package dev.eventchain.catalogue.arxml;

import dev.eventchain.diagnostics.SourceLocation;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Numbers between two limits, of which each may be missing. */
record ArxmlLimits(Optional<BigDecimal> least, Optional<BigDecimal> most) {

  /** Limits that all numbers are within. */
  static final ArxmlLimits NONE = new ArxmlLimits(Optional.empty(), Optional.empty());

  /** Longest number, in characters: those that are written are far shorter. */
  private static final int LONGEST = 70;

  /** Largest exponent of ten: more than any double has. */
  private static final int LARGEST_EXPONENT = 400;

  private static final Pattern DECIMAL =
      Pattern.compile("[-+]?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE]([-+]?[0-9]{1,4}))?");

  private static final Pattern WHOLE =
      Pattern.compile("([-+]?)(?:0[xX]([0-9a-fA-F]+)|0[bB]([01]+)|0([0-7]+))");

  /** A text where a number is expected. */
  static final class NoNumberException extends Exception {
    private static final long serialVersionUID = 1L;
    private final transient SourceLocation place;

    NoNumberException(String message, SourceLocation place) {
      super(message);
      this.place = place;
    }

    SourceLocation place() {
      return place;
    }
  }

  /**
   * Returns the number that an element has as its text: decimal, or whole after 0x, 0b or 0.
   *
   * @throws NoNumberException if it is none, or beyond all floating-point numbers
   */
  static BigDecimal number(ArxmlElement element) throws NoNumberException {
    String text = element.text();
    if (text.equals("true") || text.equals("false")) {
      return text.equals("true") ? BigDecimal.ONE : BigDecimal.ZERO;
    }
    Matcher whole = WHOLE.matcher(text);
    Matcher decimal = DECIMAL.matcher(text);
    if (text.length() <= LONGEST && whole.matches()) {
      int base = whole.group(2) != null ? 16 : whole.group(3) != null ? 2 : 8;
      String digits =
          Optional.ofNullable(whole.group(2))
              .or(() -> Optional.ofNullable(whole.group(3)))
              .orElseGet(() -> whole.group(4));
      return new BigDecimal(new BigInteger(whole.group(1) + digits, base));
    }
    if (text.length() <= LONGEST && decimal.matches()) {
      String exponent = decimal.group(1) == null ? "0" : decimal.group(1);
      if (Math.abs(Integer.parseInt(exponent)) <= LARGEST_EXPONENT) {
        return new BigDecimal(text);
      }
    }
    throw new NoNumberException(
        "'" + element.tag() + "' is no number that is read.", element.location());
  }

  /**
   * Returns a whole number.
   *
   * @throws NoNumberException if it is none from 0 to a largest one
   */
  static long whole(ArxmlElement element, long largest) throws NoNumberException {
    BigDecimal number = number(element).stripTrailingZeros();
    if (number.scale() > 0
        || number.signum() < 0
        || number.compareTo(BigDecimal.valueOf(largest)) > 0) {
      throw new NoNumberException(
          String.format(
              Locale.ROOT, "'%s' is no whole number from 0 to %d.", element.tag(), largest),
          element.location());
    }
    return number.longValueExact();
  }

  /**
   * Returns the limits of an element.
   *
   * @param step the distance of numbers; a limit that does not belong to them is moved by it. Zero
   *     for numbers without steps, of which an open limit is read as a closed one
   * @param first a number from which steps are counted
   */
  static ArxmlLimits of(ArxmlElement element, BigDecimal step, BigDecimal first)
      throws NoNumberException {
    return new ArxmlLimits(
        limit(element, "LOWER-LIMIT", step, first),
        limit(element, "UPPER-LIMIT", step.negate(), first));
  }

  private static Optional<BigDecimal> limit(
      ArxmlElement element, String tag, BigDecimal step, BigDecimal first)
      throws NoNumberException {
    Optional<ArxmlElement> limit = element.first(tag).filter(it -> !it.text().isEmpty());
    if (limit.isEmpty()
        || limit.get().attribute("INTERVAL-TYPE").equals("INFINITE")
        || limit.get().text().matches("[-+]?INF")) {
      return Optional.empty();
    }
    BigDecimal number = number(limit.get());
    boolean moves =
        limit.get().attribute("INTERVAL-TYPE").equals("OPEN")
            && step.signum() != 0
            && number.subtract(first).remainder(step).signum() == 0;
    return Optional.of(moves ? number.add(step) : number);
  }

  /** Returns the numbers that are within these and other limits. */
  ArxmlLimits and(ArxmlLimits other) {
    return new ArxmlLimits(
        least.map(it -> other.least.map(it::max).orElse(it)).or(other::least),
        most.map(it -> other.most.map(it::min).orElse(it)).or(other::most));
  }

  /** Returns the limits of the numbers within these or other ones, and those between. */
  ArxmlLimits around(ArxmlLimits other) {
    return new ArxmlLimits(
        least.flatMap(it -> other.least.map(it::min)), most.flatMap(it -> other.most.map(it::max)));
  }

  /** Returns the limits of the numbers times a factor, plus an offset. */
  ArxmlLimits scaled(BigDecimal factor, BigDecimal offset) {
    Optional<BigDecimal> one = least.map(it -> it.multiply(factor).add(offset));
    Optional<BigDecimal> other = most.map(it -> it.multiply(factor).add(offset));
    return factor.signum() < 0 ? new ArxmlLimits(other, one) : new ArxmlLimits(one, other);
  }
}

package dev.eventchain.catalogue.arxml;

import dev.eventchain.catalogue.arxml.ArxmlLimits.NoNumberException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Physical values of raw numbers: a line, texts, or both, as a COMPU-METHOD has them.
 *
 * @param factor of a raw number
 * @param offset added after that
 * @param limits the raw numbers that are on the line; with texts only, those with a text
 * @param texts the meanings of raw numbers, which are without zeros at their ends
 */
record ArxmlScaling(
    BigDecimal factor, BigDecimal offset, ArxmlLimits limits, Map<BigDecimal, String> texts) {

  /** Raw numbers as they are. */
  static final ArxmlScaling PLAIN =
      new ArxmlScaling(BigDecimal.ONE, BigDecimal.ZERO, ArxmlLimits.NONE, Map.of());

  private static final BigDecimal MOST_NUMBERS_OF_A_TEXT = BigDecimal.valueOf(256);

  /** A line, with the raw numbers for which it holds. */
  private record Line(BigDecimal factor, BigDecimal offset, ArxmlLimits limits) {

    boolean goesOnIn(Line other) {
      return factor.compareTo(other.factor) == 0 && offset.compareTo(other.offset) == 0;
    }

    Line inverse() {
      BigDecimal steep = BigDecimal.ONE.divide(factor, MathContext.DECIMAL128);
      BigDecimal zero = offset.negate().divide(factor, MathContext.DECIMAL128);
      return new Line(trimmed(steep), trimmed(zero), limits.scaled(factor, offset));
    }
  }

  /** Reader of a method. */
  private static final class Reader {
    private final ArxmlElement method;
    private final BigDecimal step;
    private final ArxmlUnread unread;
    private final List<Line> lines = new ArrayList<>();
    private final Map<BigDecimal, String> texts = new LinkedHashMap<>();
    private Optional<ArxmlLimits> ofTexts = Optional.empty();
    private boolean isCurve;

    Reader(ArxmlElement method, BigDecimal step, ArxmlUnread unread) {
      this.method = method;
      this.step = step;
      this.unread = unread;
    }

    Optional<ArxmlScaling> read() throws NoNumberException {
      String category = method.text("CATEGORY").orElse("IDENTICAL");
      if (category.startsWith("BITFIELD")) {
        unread.note(ArxmlUnread.Kind.MASK, method.path(), method.location());
        return Optional.of(PLAIN);
      }
      for (ArxmlElement scale : scales("COMPU-INTERNAL-TO-PHYS")) {
        scale(scale);
      }
      if (lines.isEmpty() && texts.isEmpty()) {
        for (ArxmlElement scale : scales("COMPU-PHYS-TO-INTERNAL")) {
          inverse(scale);
        }
      }
      boolean nothing = lines.isEmpty() && ofTexts.isEmpty();
      if (isCurve || (nothing && !category.equals("IDENTICAL")) || !isOneLine()) {
        unread.note(ArxmlUnread.Kind.CURVE, method.path(), method.location());
        return Optional.empty();
      }
      return Optional.of(nothing ? PLAIN : scaling());
    }

    private List<ArxmlElement> scales(String direction) {
      return method.all(direction, "COMPU-SCALES", "COMPU-SCALE");
    }

    private boolean isOneLine() {
      return lines.stream().allMatch(each -> each.goesOnIn(lines.get(0)));
    }

    private ArxmlScaling scaling() {
      if (lines.isEmpty()) {
        return new ArxmlScaling(
            BigDecimal.ONE, BigDecimal.ZERO, ofTexts.orElse(ArxmlLimits.NONE), texts);
      }
      ArxmlLimits limits =
          lines.stream().map(Line::limits).reduce(ArxmlLimits::around).orElse(ArxmlLimits.NONE);
      return new ArxmlScaling(lines.get(0).factor(), lines.get(0).offset(), limits, texts);
    }

    private void scale(ArxmlElement scale) throws NoNumberException {
      Optional<ArxmlElement> text = scale.first("COMPU-CONST", "VT");
      if (text.isPresent()) {
        text(scale, text.get().text());
      } else {
        line(scale, step).ifPresentOrElse(lines::add, () -> isCurve = true);
      }
    }

    private void inverse(ArxmlElement scale) throws NoNumberException {
      Optional<Line> line = line(scale, BigDecimal.ZERO).filter(it -> it.factor().signum() != 0);
      line.map(Line::inverse).ifPresentOrElse(lines::add, () -> isCurve = true);
    }

    /** Returns the line of a scale, which is the quotient of two polynomials. */
    private static Optional<Line> line(ArxmlElement scale, BigDecimal step)
        throws NoNumberException {
      Optional<ArxmlElement> quotient = scale.first("COMPU-RATIONAL-COEFFS");
      ArxmlLimits limits = ArxmlLimits.of(scale, step, BigDecimal.ZERO);
      if (quotient.isEmpty()) {
        return scale.first("COMPU-CONST").isPresent()
            ? Optional.empty()
            : Optional.of(new Line(BigDecimal.ONE, BigDecimal.ZERO, limits));
      }
      List<BigDecimal> above = coefficients(quotient.get(), "COMPU-NUMERATOR");
      List<BigDecimal> below = coefficients(quotient.get(), "COMPU-DENOMINATOR");
      if (above.size() != 2 || below.size() != 1) {
        return Optional.empty();
      }
      return Optional.of(
          new Line(
              quotient(above.get(1), below.get(0)), quotient(above.get(0), below.get(0)), limits));
    }

    /** Returns the coefficients of a polynomial, without zeros for its highest powers. */
    private static List<BigDecimal> coefficients(ArxmlElement quotient, String tag)
        throws NoNumberException {
      List<BigDecimal> numbers = new ArrayList<>();
      for (ArxmlElement each : quotient.all(tag, "V")) {
        numbers.add(ArxmlLimits.number(each));
      }
      while (!numbers.isEmpty() && numbers.get(numbers.size() - 1).signum() == 0) {
        numbers.remove(numbers.size() - 1);
      }
      return numbers;
    }

    private static BigDecimal quotient(BigDecimal number, BigDecimal divisor) {
      return trimmed(number.divide(divisor, MathContext.DECIMAL128));
    }

    /** Reads the text of one number, or of all whole numbers between limits. */
    private void text(ArxmlElement scale, String text) throws NoNumberException {
      ArxmlLimits limits = limitsOfText(scale);
      String name = text.isEmpty() ? scale.text("SHORT-LABEL").orElse("") : text;
      ofTexts = Optional.of(ofTexts.map(limits::around).orElse(limits));
      Optional<BigDecimal> count =
          limits.most().flatMap(to -> limits.least().map(from -> to.subtract(from)));
      if (count.filter(it -> it.compareTo(MOST_NUMBERS_OF_A_TEXT) < 0).isEmpty()) {
        unread.note(ArxmlUnread.Kind.WIDE, method.path() + " " + name, scale.location());
      } else if (!name.isEmpty()) {
        BigDecimal next = limits.least().orElseThrow().setScale(0, RoundingMode.CEILING);
        for (; next.compareTo(limits.most().orElseThrow()) <= 0; next = next.add(BigDecimal.ONE)) {
          texts.putIfAbsent(trimmed(next), name);
        }
      }
    }

    /** Returns the limits of a text; one that is there alone is its number. */
    private ArxmlLimits limitsOfText(ArxmlElement scale) throws NoNumberException {
      ArxmlLimits limits = ArxmlLimits.of(scale, step, BigDecimal.ZERO);
      if (scale.first("LOWER-LIMIT").isPresent() && scale.first("UPPER-LIMIT").isPresent()) {
        return limits;
      }
      Optional<BigDecimal> number = limits.least().or(limits::most);
      if (number.isEmpty()) {
        throw new NoNumberException("This text has no number.", scale.location());
      }
      return new ArxmlLimits(number, number);
    }
  }

  /**
   * Reads a method.
   *
   * @param step the distance of raw numbers, by which open limits move; zero for floating-point
   *     numbers
   * @param unread takes what is not read
   * @return empty if its values are no line over the raw numbers
   */
  static Optional<ArxmlScaling> of(ArxmlElement method, BigDecimal step, ArxmlUnread unread)
      throws NoNumberException {
    return new Reader(method, step, unread).read();
  }

  static BigDecimal trimmed(BigDecimal number) {
    return number.signum() == 0 ? BigDecimal.ZERO : number.stripTrailingZeros();
  }
}

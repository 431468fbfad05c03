package dev.eventchain.catalogue.network;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Predicate;

/**
 * Physical values of a signal: each raw number times the factor, plus the offset.
 *
 * @param type the smallest type of a message field that holds them: that of whole numbers where
 *     factor and offset are, and a float of as many digits as the raw numbers have otherwise
 * @param least the least value, of those that the bits hold, within the stated range or with a text
 * @param most the greatest value
 * @param isOutside whether a range is stated that has none of the values that the bits hold
 * @param special raw numbers with a text whose values are outside the stated range, such as those
 *     that stand for an error
 */
public record SignalValues(
    String type,
    OptionalDouble least,
    OptionalDouble most,
    boolean isOutside,
    List<BigDecimal> special) {

  /** Bits of a raw number that a float32 holds. */
  private static final int DIGITS = 24;

  private static final List<Integer> SIZES = List.of(8, 16, 32, 64);

  /** Copies the list. */
  public SignalValues {
    special = List.copyOf(special);
  }

  /** Returns the values of a signal; empty if it is a float of another size than its bits. */
  public static Optional<SignalValues> of(NetworkSignal signal) {
    return switch (signal.coding()) {
      case INTEGER -> Optional.of(integer(signal));
      case FLOAT -> floating(signal, 32);
      case DOUBLE -> floating(signal, 64);
    };
  }

  private static Optional<SignalValues> floating(NetworkSignal signal, int bits) {
    NetworkSignal.Layout layout = signal.layout();
    if (layout.length() != bits) {
      return Optional.empty();
    }
    boolean scaled =
        layout.factor().compareTo(BigDecimal.ONE) != 0 || layout.offset().signum() != 0;
    String type = bits == 64 || scaled ? "float64" : "float32";
    if (!layout.hasRange() || layout.isTurned()) {
      OptionalDouble any = OptionalDouble.empty();
      return Optional.of(new SignalValues(type, any, any, layout.hasRange(), List.of()));
    }
    return Optional.of(
        within(
            layout,
            type,
            layout.least(),
            layout.most(),
            special(signal, raw -> finite(layout.physical(raw)).isPresent())));
  }

  private static SignalValues integer(NetworkSignal signal) {
    NetworkSignal.Layout layout = signal.layout();
    int bits = layout.length();
    BigInteger count = BigInteger.ONE.shiftLeft(layout.signed() ? bits - 1 : bits);
    BigDecimal lowest = new BigDecimal(layout.signed() ? count.negate() : BigInteger.ZERO);
    BigDecimal highest = new BigDecimal(count.subtract(BigInteger.ONE));
    BigDecimal one = layout.physical(lowest);
    BigDecimal other = layout.physical(highest);
    BigDecimal least = one.min(other);
    BigDecimal most = one.max(other);
    String type = type(layout, least, most);
    boolean outside =
        layout.hasRange()
            && (layout.isTurned()
                || layout.least().filter(it -> it.compareTo(most) > 0).isPresent()
                || layout.most().filter(it -> it.compareTo(least) < 0).isPresent());
    if (!layout.hasRange() || outside || type.equals("bool")) {
      return new SignalValues(type, finite(least), finite(most), outside, List.of());
    }
    List<BigDecimal> special =
        special(
            signal,
            raw -> isWhole(raw) && raw.compareTo(lowest) >= 0 && raw.compareTo(highest) <= 0);
    return within(
        layout,
        type,
        Optional.of(layout.least().map(least::max).orElse(least)),
        Optional.of(layout.most().map(most::min).orElse(most)),
        special);
  }

  /** Returns the raw numbers that the bits hold, with a text and outside the stated range. */
  private static List<BigDecimal> special(NetworkSignal signal, Predicate<BigDecimal> held) {
    NetworkSignal.Layout layout = signal.layout();
    return signal.texts().keySet().stream()
        .filter(held)
        .filter(raw -> layout.excludes(layout.physical(raw)))
        .toList();
  }

  /** Returns the values from a least to a greatest one, and those of special raw numbers. */
  private static SignalValues within(
      NetworkSignal.Layout layout,
      String type,
      Optional<BigDecimal> least,
      Optional<BigDecimal> most,
      List<BigDecimal> special) {
    List<BigDecimal> values = special.stream().map(layout::physical).toList();
    return new SignalValues(
        type,
        finite(least.map(it -> values.stream().reduce(it, BigDecimal::min))),
        finite(most.map(it -> values.stream().reduce(it, BigDecimal::max))),
        false,
        special);
  }

  private static String type(NetworkSignal.Layout layout, BigDecimal least, BigDecimal most) {
    boolean plain = layout.factor().compareTo(BigDecimal.ONE) == 0 && layout.offset().signum() == 0;
    if (plain && layout.length() == 1 && !layout.signed()) {
      return "bool";
    }
    if (isWhole(layout.factor()) && isWhole(layout.offset())) {
      for (int size : SIZES) {
        if (least.signum() >= 0 && most.toBigInteger().bitLength() <= size) {
          return "uint" + size;
        }
        boolean fits =
            least.toBigInteger().bitLength() < size && most.toBigInteger().bitLength() < size;
        if (fits) {
          return "int" + size;
        }
      }
    }
    return layout.length() <= DIGITS ? "float32" : "float64";
  }

  /** Returns a number with all of its digits, and without zeros at its end. */
  public static String plain(BigDecimal number) {
    return number.stripTrailingZeros().toPlainString();
  }

  private static boolean isWhole(BigDecimal number) {
    return number.stripTrailingZeros().scale() <= 0;
  }

  private static OptionalDouble finite(Optional<BigDecimal> number) {
    return number.map(SignalValues::finite).orElse(OptionalDouble.empty());
  }

  private static OptionalDouble finite(BigDecimal number) {
    double value = number.doubleValue();
    return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
  }
}

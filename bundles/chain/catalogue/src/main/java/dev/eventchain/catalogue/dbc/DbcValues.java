package dev.eventchain.catalogue.dbc;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Physical values of a signal: each raw number times the factor, plus the offset.
 *
 * @param type the smallest type of a message field that holds them: that of whole numbers where
 *     factor and offset are, and a float of as many digits as the raw numbers have otherwise
 * @param least the least value, of those that the bits hold and of the stated range
 * @param most the greatest value
 * @param isOutside whether a range is stated that has none of the values that the bits hold
 */
record DbcValues(String type, OptionalDouble least, OptionalDouble most, boolean isOutside) {

  /** Bits of a raw number that a float32 holds. */
  private static final int DIGITS = 24;

  private static final List<Integer> SIZES = List.of(8, 16, 32, 64);

  /** Returns the values of a signal; empty if it is a float of another size than its bits. */
  static Optional<DbcValues> of(DbcSignal signal) {
    DbcSignal.Layout layout = signal.layout();
    return switch (signal.coding()) {
      case INTEGER -> Optional.of(integer(layout));
      case FLOAT -> floating(layout, 32);
      case DOUBLE -> floating(layout, 64);
    };
  }

  private static Optional<DbcValues> floating(DbcSignal.Layout layout, int bits) {
    if (layout.length() != bits) {
      return Optional.empty();
    }
    boolean scaled =
        layout.factor().compareTo(BigDecimal.ONE) != 0 || layout.offset().signum() != 0;
    String type = bits == 64 || scaled ? "float64" : "float32";
    boolean none = !layout.hasRange() || layout.least().compareTo(layout.most()) > 0;
    return Optional.of(
        new DbcValues(
            type,
            none ? OptionalDouble.empty() : finite(layout.least()),
            none ? OptionalDouble.empty() : finite(layout.most()),
            none && layout.hasRange()));
  }

  private static DbcValues integer(DbcSignal.Layout layout) {
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
            && (layout.least().compareTo(layout.most()) > 0
                || layout.least().compareTo(most) > 0
                || layout.most().compareTo(least) < 0);
    if (layout.hasRange() && !outside) {
      least = least.max(layout.least());
      most = most.min(layout.most());
    }
    return new DbcValues(type, finite(least), finite(most), outside);
  }

  private static String type(DbcSignal.Layout layout, BigDecimal least, BigDecimal most) {
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
  static String plain(BigDecimal number) {
    return number.stripTrailingZeros().toPlainString();
  }

  private static boolean isWhole(BigDecimal number) {
    return number.stripTrailingZeros().scale() <= 0;
  }

  private static OptionalDouble finite(BigDecimal number) {
    double value = number.doubleValue();
    return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
  }
}

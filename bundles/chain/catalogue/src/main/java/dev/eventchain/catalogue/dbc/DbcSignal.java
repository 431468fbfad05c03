package dev.eventchain.catalogue.dbc;

import dev.eventchain.diagnostics.SourceLocation;
import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/** A signal of a message, while its statements are read. */
final class DbcSignal {

  /**
   * Place and coding of a signal.
   *
   * @param start the first bit of a little-endian signal, and the most significant one of a
   *     big-endian one, counted from 0 in bytes of eight
   * @param length in bits
   * @param factor of a raw number
   * @param offset added after that
   * @param least and {@code most}: the stated range; both 0 for none
   */
  record Layout(
      int start,
      int length,
      boolean bigEndian,
      boolean signed,
      BigDecimal factor,
      BigDecimal offset,
      BigDecimal least,
      BigDecimal most) {

    /** Returns whether all bits are in a message of some bytes. */
    boolean fits(int size) {
      long bits = 8L * size;
      if (!bigEndian) {
        return start + (long) length <= bits;
      }
      // Bits go down to the least significant one of a byte, and on with the next byte.
      long position = 8L * (start / 8) + 7 - start % 8;
      return position + length <= bits;
    }

    /** Returns the numbers of all bits, which are counted from the least one of each byte. */
    List<Integer> bits() {
      int first = 8 * (start / 8) + 7 - start % 8;
      return IntStream.range(0, length)
          .map(i -> bigEndian ? 8 * ((first + i) / 8) + 7 - (first + i) % 8 : start + i)
          .boxed()
          .toList();
    }

    /** Returns what a raw number means, in the unit of the signal. */
    BigDecimal physical(BigDecimal raw) {
      return raw.multiply(factor).add(offset);
    }

    boolean hasRange() {
      return least.signum() != 0 || most.signum() != 0;
    }
  }

  /** Coding of the raw value. */
  enum Coding {
    INTEGER,
    FLOAT,
    DOUBLE
  }

  private final String name;
  private final String multiplexing;
  private final Layout layout;
  private final String unit;
  private final SourceLocation place;
  private final Map<BigDecimal, String> texts = new LinkedHashMap<>();
  private Coding coding = Coding.INTEGER;
  private String longName = "";
  private String comment = "";
  private Optional<DbcCondition> condition = Optional.empty();

  /**
   * Creates a signal.
   *
   * @param multiplexing {@code M}, {@code m0}, {@code m0M}, or empty
   */
  DbcSignal(String name, String multiplexing, Layout layout, String unit, SourceLocation place) {
    this.name = name;
    this.multiplexing = multiplexing;
    this.layout = layout;
    this.unit = unit;
    this.place = place;
  }

  String name() {
    return longName.isEmpty() ? name : longName;
  }

  boolean isMultiplexer() {
    return multiplexing.endsWith("M");
  }

  /** Returns the number of the multiplexer with which it is there; empty if it always is. */
  String multiplexed() {
    return multiplexing.replaceAll("[mM]", "");
  }

  Layout layout() {
    return layout;
  }

  String unit() {
    return unit;
  }

  SourceLocation place() {
    return place;
  }

  /** Returns the meanings of raw numbers, which are without zeros at their ends. */
  Map<BigDecimal, String> texts() {
    return texts;
  }

  Coding coding() {
    return coding;
  }

  String comment() {
    return comment;
  }

  /** Returns when it is there by a statement of its own. */
  Optional<DbcCondition> condition() {
    return condition;
  }

  void rename(String full) {
    longName = full;
  }

  void comment(String text) {
    comment = text;
  }

  void coding(Coding other) {
    coding = other;
  }

  void condition(DbcCondition when) {
    condition = Optional.of(when);
  }
}

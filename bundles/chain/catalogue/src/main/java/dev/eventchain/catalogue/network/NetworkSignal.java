package dev.eventchain.catalogue.network;

import dev.eventchain.diagnostics.SourceLocation;
import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/** A signal of a message, while its description is read. */
public final class NetworkSignal {

  /**
   * Place and coding of a signal.
   *
   * @param start the first bit of a little-endian signal, and the most significant one of a
   *     big-endian one, counted from 0 in bytes of eight
   * @param length in bits
   * @param factor of a raw number
   * @param offset added after that
   * @param least the least value of the stated range; empty for none
   * @param most the greatest one
   */
  public record Layout(
      int start,
      int length,
      boolean bigEndian,
      boolean signed,
      BigDecimal factor,
      BigDecimal offset,
      Optional<BigDecimal> least,
      Optional<BigDecimal> most) {

    /** Returns whether all bits are in a message of some bytes. */
    public boolean fits(int size) {
      long bits = 8L * size;
      if (!bigEndian) {
        return start + (long) length <= bits;
      }
      // Bits go down to the least significant one of a byte, and on with the next byte.
      long position = 8L * (start / 8) + 7 - start % 8;
      return position + length <= bits;
    }

    /** Returns the numbers of all bits, which are counted from the least one of each byte. */
    public List<Integer> bits() {
      int first = 8 * (start / 8) + 7 - start % 8;
      return IntStream.range(0, length)
          .map(i -> bigEndian ? 8 * ((first + i) / 8) + 7 - (first + i) % 8 : start + i)
          .boxed()
          .toList();
    }

    /** Returns what a raw number means, in the unit of the signal. */
    public BigDecimal physical(BigDecimal raw) {
      return raw.multiply(factor).add(offset);
    }

    public boolean hasRange() {
      return least.isPresent() || most.isPresent();
    }

    /** Returns whether a value is outside the stated range. */
    public boolean excludes(BigDecimal value) {
      return least.filter(it -> value.compareTo(it) < 0).isPresent()
          || most.filter(it -> value.compareTo(it) > 0).isPresent();
    }

    /** Returns whether the stated range ends before it begins. */
    boolean isTurned() {
      return most.filter(end -> least.filter(it -> it.compareTo(end) > 0).isPresent()).isPresent();
    }
  }

  /** Coding of the raw value. */
  public enum Coding {
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
  private OptionalInt cycle = OptionalInt.empty();
  private Optional<BigDecimal> initial = Optional.empty();
  private Optional<SendingCondition> condition = Optional.empty();

  /**
   * Creates a signal.
   *
   * @param multiplexing {@code M}, {@code m0}, {@code m0M}, or empty
   */
  public NetworkSignal(
      String name, String multiplexing, Layout layout, String unit, SourceLocation place) {
    this.name = name;
    this.multiplexing = multiplexing;
    this.layout = layout;
    this.unit = unit;
    this.place = place;
  }

  public String name() {
    return longName.isEmpty() ? name : longName;
  }

  public boolean isMultiplexer() {
    return multiplexing.endsWith("M");
  }

  /** Returns the number of the multiplexer with which it is there; empty if it always is. */
  public String multiplexed() {
    return multiplexing.replaceAll("[mM]", "");
  }

  public Layout layout() {
    return layout;
  }

  public String unit() {
    return unit;
  }

  public SourceLocation place() {
    return place;
  }

  /** Returns the meanings of raw numbers, which are without zeros at their ends. */
  public Map<BigDecimal, String> texts() {
    return texts;
  }

  public Coding coding() {
    return coding;
  }

  public String comment() {
    return comment;
  }

  /** Returns the time between two of it in ms, if that is not the one of its message. */
  public OptionalInt cycle() {
    return cycle;
  }

  /** Returns the raw number that is sent before any other. */
  public Optional<BigDecimal> initial() {
    return initial;
  }

  /** Returns when it is there by a statement of its own. */
  public Optional<SendingCondition> condition() {
    return condition;
  }

  public void rename(String full) {
    longName = full;
  }

  public void comment(String text) {
    comment = text;
  }

  public void coding(Coding other) {
    coding = other;
  }

  public void cycle(int milliseconds) {
    cycle = OptionalInt.of(milliseconds);
  }

  public void initial(BigDecimal raw) {
    initial = Optional.of(raw);
  }

  public void condition(SendingCondition when) {
    condition = Optional.of(when);
  }
}

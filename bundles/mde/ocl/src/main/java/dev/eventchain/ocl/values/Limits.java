package dev.eventchain.ocl.values;

import dev.eventchain.ocl.evaluation.Invalid;
import java.util.Collection;

/**
 * How large a value may become. An evaluation that goes beyond is halted: it would end in a want of
 * memory, and not only its own.
 */
public final class Limits {

  private static final int MOST_ELEMENTS = 4_000_000;
  public static final int MOST_CHARACTERS = 16_000_000;
  static final int MOST_BITS = 100_000;

  private Limits() {}

  /** Halts what makes a collection that is too large. */
  public static void requireElements(long elements) {
    if (elements > MOST_ELEMENTS) {
      throw tooLarge("a collection of more than " + MOST_ELEMENTS + " elements");
    }
  }

  /** Halts what makes an Integer that is too large. */
  static void requireBits(long bits) {
    if (bits > MOST_BITS) {
      throw tooLarge("a number of more than " + MOST_BITS + " bits");
    }
  }

  /** Halts what makes a text that is too long. */
  public static void requireCharacters(long characters) {
    if (characters > MOST_CHARACTERS) {
      throw tooLarge("a string of more than " + MOST_CHARACTERS + " characters");
    }
  }

  private static Halted tooLarge(String what) {
    return new Halted("it makes " + what, Invalid.Kind.COST);
  }

  /** Halts what made a value that is too large, and gives the value otherwise. */
  public static Object require(Object value) {
    if (value instanceof String text) {
      requireCharacters(text.length());
    } else if (value instanceof Collection<?> elements) {
      requireElements(elements.size());
    }
    return value;
  }
}

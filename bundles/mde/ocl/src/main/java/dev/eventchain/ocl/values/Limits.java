package dev.eventchain.ocl.values;

import dev.eventchain.ocl.evaluation.Invalid;
import java.util.Collection;

/**
 * Limits of the size of values. An evaluation that exceeds them is halted, before it exhausts the
 * memory of the process.
 */
public final class Limits {

  private static final int MOST_ELEMENTS = 4_000_000;
  public static final int MOST_CHARACTERS = 16_000_000;
  static final int MOST_BITS = 100_000;

  private Limits() {}

  /** Halts the evaluation if a collection is too large. */
  public static void requireElements(long elements) {
    if (elements > MOST_ELEMENTS) {
      throw tooLarge("a collection of more than " + MOST_ELEMENTS + " elements");
    }
  }

  /** Halts the evaluation if an Integer is too large. */
  static void requireBits(long bits) {
    if (bits > MOST_BITS) {
      throw tooLarge("a number of more than " + MOST_BITS + " bits");
    }
  }

  /** Halts the evaluation if a text is too long. */
  public static void requireCharacters(long characters) {
    if (characters > MOST_CHARACTERS) {
      throw tooLarge("a string of more than " + MOST_CHARACTERS + " characters");
    }
  }

  private static Halted tooLarge(String what) {
    return new Halted("it makes " + what, Invalid.Kind.COST);
  }

  /** Halts the evaluation if a value is too large, and returns the value otherwise. */
  public static Object require(Object value) {
    if (value instanceof String text) {
      requireCharacters(text.length());
    } else if (value instanceof Collection<?> elements) {
      requireElements(elements.size());
    }
    return value;
  }
}

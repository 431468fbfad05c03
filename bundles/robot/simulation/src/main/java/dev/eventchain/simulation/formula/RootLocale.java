package dev.eventchain.simulation.formula;

import java.util.Locale;

/** Formatting of numbers in text, independent of the machine's locale. */
public final class RootLocale {

  private RootLocale() {}

  /** Formats as {@link String#format(Locale, String, Object...)} does in the root locale. */
  public static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}

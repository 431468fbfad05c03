package dev.eventchain.simulation.formula;

import java.util.Locale;

/** Text with numbers in it that is the same on every machine. */
public final class RootLocale {

  private RootLocale() {}

  /** As {@link String#format(Locale, String, Object...)} in the root locale. */
  public static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}

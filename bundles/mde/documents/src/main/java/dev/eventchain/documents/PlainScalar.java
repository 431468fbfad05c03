package dev.eventchain.documents;

import java.util.regex.Pattern;

/**
 * Types of a YAML scalar without quotes. Versions of YAML disagree about {@code yes}, {@code 012},
 * {@code 1:30}, {@code 0x1F} or {@code 1_000}. These are text, which is refused where a number or a
 * Boolean is required.
 */
enum PlainScalar {
  NOTHING,
  TRUE,
  FALSE,
  WHOLE_NUMBER,
  NUMBER,
  TEXT;

  private static final int LONGEST_NUMBER = 1000;
  private static final Pattern WHOLE = Pattern.compile("[-+]?(0|[1-9][0-9]*)");
  private static final Pattern DECIMAL =
      Pattern.compile("[-+]?((0|[1-9][0-9]*)(\\.[0-9]*)?|\\.[0-9]+)([eE][-+]?[0-9]{1,9})?");

  static PlainScalar of(String written) {
    return switch (written) {
      case "", "~", "null", "Null", "NULL" -> NOTHING;
      case "true" -> TRUE;
      case "false" -> FALSE;
      default -> number(written);
    };
  }

  private static PlainScalar number(String written) {
    if (written.length() > LONGEST_NUMBER) {
      return TEXT;
    }
    if (WHOLE.matcher(written).matches()) {
      return WHOLE_NUMBER;
    }
    return DECIMAL.matcher(written).matches() ? NUMBER : TEXT;
  }
}

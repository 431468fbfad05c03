package dev.eventchain.documents;

import com.fasterxml.jackson.databind.JsonNode;

/** Hints about values of the wrong type. */
final class TypeHint {

  private TypeHint() {}

  /** Returns the hint; empty if the message suffices. */
  static String of(String wanted, JsonNode value) {
    if (wanted.equals("a string")) {
      return value.isNumber() || value.isBoolean()
          ? "Put it in quotes: \"" + value.asText() + "\"."
          : "";
    }
    return wanted.endsWith("number") && value.isTextual() ? number(value.textValue()) : "";
  }

  private static String number(String written) {
    PlainScalar meant = PlainScalar.of(written.strip());
    if (meant == PlainScalar.WHOLE_NUMBER || meant == PlainScalar.NUMBER) {
      return "Leave the quotes out.";
    }
    if (written.matches("[-+]?0[0-9_.]+")) {
      return "Leave out the leading zeros.";
    }
    return written.matches("[-+.]?[0-9].*") ? "Write it in decimal digits: 90, 0.5 or 1.5e3." : "";
  }
}

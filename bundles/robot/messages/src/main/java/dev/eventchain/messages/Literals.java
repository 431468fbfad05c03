package dev.eventchain.messages;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Literals of message definitions (rosidl_adapter, {@code parse_value_string}). */
final class Literals {

  private static final String DIGITS = "\\d+(?:_\\d+)*";
  private static final Pattern INTEGER =
      Pattern.compile(
          "(?<sign>[+-]?)(?:(?<decimal>"
              + DIGITS
              + ")|0x(?<hexadecimal>(?:_?[0-9a-f])+)|0o(?<octal>(?:_?[0-7])+)"
              + "|0b(?<binary>(?:_?[01])+))");
  private static final Map<String, Integer> RADICES =
      Map.of("decimal", 10, "hexadecimal", 16, "octal", 8, "binary", 2);
  private static final Pattern DECIMAL =
      Pattern.compile("[+-]?(?:#\\.?(?:#)?|\\.#)(?:e[+-]?#)?".replace("#", DIGITS));
  private static final Pattern SPECIAL = Pattern.compile("(?<sign>[+-]?)(?:inf(?:inity)?|(nan))");

  private Literals() {}

  /**
   * Parses the value of a constant or the default of a field.
   *
   * @return a value as {@link MessageValue} holds it
   * @throws IllegalArgumentException with a sentence that describes the error
   */
  static Object parse(FieldType type, String text, boolean constant) {
    if (type.kind() == FieldType.Kind.MESSAGE) {
      throw new IllegalArgumentException("A field of a message type cannot have a value.");
    }
    if (constant && type.stringBound() > 0) {
      throw new IllegalArgumentException("A constant is a string without a bound.");
    }
    if (type.shape() == FieldType.Shape.SINGLE) {
      return Values.coerce(type, single(type.kind(), text.strip()));
    }
    if (constant || !text.startsWith("[") || !text.endsWith("]")) {
      throw new IllegalArgumentException("The value of an array is written in brackets, [1, 2].");
    }
    String inner = text.substring(1, text.length() - 1);
    List<Object> items = new ArrayList<>();
    for (String item : type.kind() == FieldType.Kind.STRING ? texts(inner) : separated(inner)) {
      items.add(single(type.kind(), item.strip()));
    }
    return Values.coerce(type, items);
  }

  /** Returns a string in double quotes, as {@link #parse} reads it. */
  static String quoted(String text) {
    return '"' + text.replace("\"", "\\\"") + '"';
  }

  private static List<String> separated(String text) {
    return text.isEmpty() ? List.of() : List.of(text.split(",", -1));
  }

  /** Splits strings at commas outside quotes. */
  private static List<String> texts(String text) {
    List<String> texts = new ArrayList<>();
    String rest = text;
    while (!rest.isEmpty()) {
      rest = rest.stripLeading();
      if (rest.isEmpty() || rest.startsWith(",")) {
        throw new IllegalArgumentException("A value is missing in [" + text + "].");
      }
      boolean inQuotes = rest.startsWith("\"") || rest.startsWith("'");
      int end = inQuotes ? closing(rest) : rest.indexOf(',');
      String item = end < 0 ? rest : rest.substring(0, end);
      rest = rest.substring(item.length()).stripLeading();
      texts.add(inQuotes ? unquoted(item) : item);
      rest = rest.startsWith(",") ? rest.substring(1) : rest;
    }
    return texts;
  }

  /** Returns the position after the closing quote of a string. */
  private static int closing(String text) {
    String quote = text.substring(0, 1);
    int end = text.indexOf(quote, 1);
    while (end > 0 && text.charAt(end - 1) == '\\') {
      end = text.indexOf(quote, end + 1);
    }
    if (end < 0) {
      throw new IllegalArgumentException("The closing quote of " + text + " is missing.");
    }
    return end + 1;
  }

  private static Object single(FieldType.Kind kind, String text) {
    return switch (kind) {
      case STRING -> unquoted(text);
      case BOOL -> truth(text);
      case FLOAT32 -> float32(text);
      case FLOAT64 -> decimal(text);
      default -> integer(text);
    };
  }

  /** Removes the surrounding quotes and the backslashes before quotes within. */
  private static String unquoted(String text) {
    for (String quote : List.of("\"", "'")) {
      if (text.startsWith(quote) && text.endsWith(quote)) {
        String inner = text.substring(1, Math.max(1, text.length() - 1));
        if (Pattern.compile("(?<!\\\\)" + quote).matcher(inner).find()) {
          throw new IllegalArgumentException(
              "A quote within a string in quotes needs a backslash, \\" + quote + ".");
        }
        return inner.replace("\\" + quote, quote);
      }
    }
    return text;
  }

  private static boolean truth(String text) {
    return switch (text.toLowerCase(Locale.ROOT)) {
      case "true", "1" -> true;
      case "false", "0" -> false;
      default -> throw new IllegalArgumentException("'" + text + "' is neither true nor false.");
    };
  }

  private static double float32(String text) {
    double value = decimal(text);
    if (Double.isFinite(value) && Float.isInfinite((float) value)) {
      throw new IllegalArgumentException(text + " is out of the range of float32.");
    }
    return value;
  }

  private static double decimal(String text) {
    String lower = text.toLowerCase(Locale.ROOT);
    Matcher special = SPECIAL.matcher(lower);
    if (special.matches()) {
      double value = special.group(2) == null ? Double.POSITIVE_INFINITY : Double.NaN;
      return special.group("sign").equals("-") ? -value : value;
    }
    if (!DECIMAL.matcher(lower).matches()) {
      throw new IllegalArgumentException("'" + text + "' is not a number.");
    }
    return Double.parseDouble(lower.replace("_", ""));
  }

  private static BigInteger integer(String text) {
    Matcher number = INTEGER.matcher(text.toLowerCase(Locale.ROOT));
    if (!number.matches()) {
      throw new IllegalArgumentException("'" + text + "' is not an integer.");
    }
    for (Map.Entry<String, Integer> radix : RADICES.entrySet()) {
      String digits = number.group(radix.getKey());
      if (digits != null) {
        BigInteger value = new BigInteger(digits.replace("_", ""), radix.getValue());
        return number.group("sign").equals("-") ? value.negate() : value;
      }
    }
    throw new IllegalStateException(text);
  }
}

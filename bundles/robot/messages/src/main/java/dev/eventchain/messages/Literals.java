package dev.eventchain.messages;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Values as a message definition writes them. */
final class Literals {

  private static final Pattern ITEM = Pattern.compile("'[^']*'|\"[^\"]*\"|[^,\\s]+");

  private Literals() {}

  /**
   * Reads a constant's value or a field's default.
   *
   * @return a value as {@link MessageValue} holds it
   * @throws IllegalArgumentException with a sentence about what is wrong
   */
  static Object parse(FieldType type, String text, boolean constant) {
    if (type.kind() == FieldType.Kind.MESSAGE) {
      throw new IllegalArgumentException("A field of a message type cannot have a value.");
    }
    if (type.shape() == FieldType.Shape.SINGLE) {
      return Values.coerce(type, single(type.kind(), text.strip()));
    }
    if (constant || !text.startsWith("[") || !text.endsWith("]")) {
      throw new IllegalArgumentException("The value of an array is written in brackets, [1, 2].");
    }
    List<Object> items = new ArrayList<>();
    Matcher item = ITEM.matcher(text.substring(1, text.length() - 1));
    while (item.find()) {
      items.add(single(type.kind(), item.group()));
    }
    return Values.coerce(type, items);
  }

  private static Object single(FieldType.Kind kind, String text) {
    return switch (kind) {
      case STRING, WSTRING -> unquoted(text);
      case BOOL -> truth(text);
      case FLOAT32, FLOAT64 -> decimal(text);
      default -> integer(text);
    };
  }

  private static String unquoted(String text) {
    boolean quoted =
        text.length() >= 2
            && (text.charAt(0) == '"' || text.charAt(0) == '\'')
            && text.charAt(text.length() - 1) == text.charAt(0);
    return quoted ? text.substring(1, text.length() - 1) : text;
  }

  private static boolean truth(String text) {
    return switch (text.toLowerCase(Locale.ROOT)) {
      case "true", "1" -> true;
      case "false", "0" -> false;
      default -> throw new IllegalArgumentException("'" + text + "' is neither true nor false.");
    };
  }

  private static double decimal(String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("'" + text + "' is not a number.", e);
    }
  }

  private static BigInteger integer(String text) {
    String digits = text.replace("_", "").toLowerCase(Locale.ROOT);
    boolean negative = digits.startsWith("-");
    String plain = negative || digits.startsWith("+") ? digits.substring(1) : digits;
    int radix =
        plain.startsWith("0x") ? 16 : plain.startsWith("0b") ? 2 : plain.startsWith("0o") ? 8 : 10;
    try {
      BigInteger value = new BigInteger(radix == 10 ? plain : plain.substring(2), radix);
      return negative ? value.negate() : value;
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("'" + text + "' is not an integer.", e);
    }
  }
}

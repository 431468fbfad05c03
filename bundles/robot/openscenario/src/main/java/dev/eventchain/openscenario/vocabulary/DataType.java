package dev.eventchain.openscenario.vocabulary;

import java.time.DateTimeException;
import java.time.LocalDateTime;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A primitive type of attributes and parameters. */
public enum DataType {
  STRING("string", "a text"),
  DOUBLE("double", "a number"),
  DOUBLE_OR_INFINITE("double", "a number or INF"),
  INT("int", "a whole number from -2147483648 to 2147483647"),
  UNSIGNED_INT("unsignedInt", "a whole number from 0 to 4294967295"),
  UNSIGNED_SHORT("unsignedShort", "a whole number from 0 to 65535"),
  BOOLEAN("boolean", "true or false"),
  DATE_TIME("dateTime", "a time such as 2026-02-24T14:44:00");

  private static final Pattern DECIMAL =
      Pattern.compile("[+-]?(?:\\d+(?:\\.\\d*)?|\\.\\d+)(?:[eE][+-]?\\d+)?");
  private static final Pattern WHOLE = Pattern.compile("[+-]?\\d{1,19}");
  private static final Pattern TIME =
      Pattern.compile(
          "(\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d(?:\\.\\d{1,9})?)\\d*(?:Z|[+-]\\d\\d:\\d\\d)?");
  private static final long LARGEST_UNSIGNED_INT = 0xFFFF_FFFFL;
  private static final long LARGEST_UNSIGNED_SHORT = 0xFFFF;

  private final String word;
  private final String description;

  DataType(String word, String description) {
    this.word = word;
    this.description = description;
  }

  /** Returns the name of a parameter's type: {@code unsignedInt}. */
  public String word() {
    return word;
  }

  /** Returns what values are, for a sentence. */
  public String description() {
    return description;
  }

  /** Returns the type of a parameter; {@code integer} is that of versions before 1.2. */
  public static Optional<DataType> ofWord(String word) {
    String latest = word.equals("integer") ? "int" : word;
    for (DataType type : values()) {
      if (type.word.equals(latest)) {
        return Optional.of(type);
      }
    }
    return Optional.empty();
  }

  /** Returns whether values are whole numbers. */
  public boolean isWhole() {
    return this == INT || this == UNSIGNED_INT || this == UNSIGNED_SHORT;
  }

  /** Returns whether values are numbers. */
  public boolean isNumber() {
    return isWhole() || this == DOUBLE || this == DOUBLE_OR_INFINITE;
  }

  /**
   * Returns a value in the form that Java reads, {@code true} for {@code 1}; empty if it is not of
   * this type.
   */
  public Optional<String> canonical(String written) {
    String value = this == STRING ? written : written.strip();
    return switch (this) {
      case STRING -> Optional.of(value);
      case DOUBLE -> decimal(value);
      case DOUBLE_OR_INFINITE -> infinite(value).or(() -> decimal(value));
      case INT -> whole(value, Integer.MIN_VALUE, Integer.MAX_VALUE);
      case UNSIGNED_INT -> whole(value, 0, LARGEST_UNSIGNED_INT);
      case UNSIGNED_SHORT -> whole(value, 0, LARGEST_UNSIGNED_SHORT);
      case BOOLEAN -> truth(value);
      case DATE_TIME -> isTime(value) ? Optional.of(value) : Optional.empty();
    };
  }

  private static Optional<String> decimal(String value) {
    return DECIMAL.matcher(value).matches() && Double.isFinite(Double.parseDouble(value))
        ? Optional.of(value)
        : Optional.empty();
  }

  private static Optional<String> infinite(String value) {
    return switch (value) {
      case "INF", "+INF" -> Optional.of("Infinity");
      case "-INF" -> Optional.of("-Infinity");
      default -> Optional.empty();
    };
  }

  private static Optional<String> whole(String value, long least, long most) {
    if (!WHOLE.matcher(value).matches()) {
      return Optional.empty();
    }
    try {
      long number = Long.parseLong(value);
      return number >= least && number <= most
          ? Optional.of(Long.toString(number))
          : Optional.empty();
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  private static Optional<String> truth(String value) {
    return switch (value) {
      case "true", "1" -> Optional.of("true");
      case "false", "0" -> Optional.of("false");
      default -> Optional.empty();
    };
  }

  private static boolean isTime(String value) {
    Matcher time = TIME.matcher(value);
    if (!time.matches()) {
      return false;
    }
    try {
      LocalDateTime.parse(time.group(1));
      return true;
    } catch (DateTimeException e) {
      return false;
    }
  }
}

package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.Limits;
import dev.eventchain.ocl.values.Numbers;
import java.util.ArrayList;
import java.util.List;
import java.util.StringTokenizer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.ocl.util.UnicodeSupport;
import org.eclipse.ocl.utilities.PredefinedType;

/** Operations of strings. */
public final class TextNodes {

  private static final String WHITE_SPACE = " \t\n\r\f";

  private TextNodes() {}

  /** An operation of a source; one that is no string makes the value invalid. */
  private abstract static class Operation extends GuardedNode {
    final int code;
    private final Node source;

    Operation(int code, Node source) {
      this.code = code;
      this.source = source;
    }

    @Override
    final Object compute(Frame frame) {
      return source.evaluate(frame) instanceof String text ? compute(text, frame) : INVALID;
    }

    abstract Object compute(String text, Frame frame);
  }

  /** An operation without arguments. */
  public static final class Unary extends Operation {

    public Unary(int code, Node source) {
      super(code, source);
    }

    public static boolean has(int code) {
      return switch (code) {
        case PredefinedType.SIZE,
            PredefinedType.TO_INTEGER,
            PredefinedType.TO_REAL,
            PredefinedType.TO_BOOLEAN,
            PredefinedType.TO_LOWER,
            PredefinedType.TO_LOWER_CASE,
            PredefinedType.TO_UPPER,
            PredefinedType.TO_UPPER_CASE,
            PredefinedType.CHARACTERS,
            PredefinedType.TOKENIZE,
            PredefinedType.TRIM ->
            true;
        default -> false;
      };
    }

    @Override
    Object compute(String text, Frame frame) {
      return Limits.require(unary(text));
    }

    private Object unary(String text) {
      return switch (code) {
        case PredefinedType.SIZE -> text.length();
        case PredefinedType.TO_INTEGER -> Numbers.integer(text);
        case PredefinedType.TO_REAL -> Numbers.real(text);
        case PredefinedType.TO_BOOLEAN -> "true".equals(text);
        case PredefinedType.TO_LOWER, PredefinedType.TO_LOWER_CASE ->
            UnicodeSupport.toLowerCase(text);
        case PredefinedType.TO_UPPER, PredefinedType.TO_UPPER_CASE ->
            UnicodeSupport.toUpperCase(text);
        case PredefinedType.CHARACTERS -> characters(text);
        case PredefinedType.TOKENIZE -> tokens(text, WHITE_SPACE, false);
        default -> text.trim();
      };
    }

    private static List<String> characters(String text) {
      List<String> result = new ArrayList<>(text.length());
      for (int i = 0; i < text.length(); i++) {
        result.add(text.substring(i, i + 1));
      }
      return result;
    }
  }

  /** An operation with one argument. */
  public static final class Binary extends Operation {
    private final Node argument;

    public Binary(int code, Node source, Node argument) {
      super(code, source);
      this.argument = argument;
    }

    public static boolean has(int code) {
      return switch (code) {
        case PredefinedType.PLUS,
            PredefinedType.CONCAT,
            PredefinedType.AT,
            PredefinedType.INDEX_OF,
            PredefinedType.LAST_INDEX_OF,
            PredefinedType.ENDS_WITH,
            PredefinedType.STARTS_WITH,
            PredefinedType.EQUALS_IGNORE_CASE,
            PredefinedType.MATCHES,
            PredefinedType.TOKENIZE ->
            true;
        default -> false;
      };
    }

    @Override
    Object compute(String text, Frame frame) {
      Object value = argument.evaluate(frame);
      if (code == PredefinedType.AT) {
        return value instanceof Integer index ? text.substring(index - 1, index) : INVALID;
      } else if (!(value instanceof String other)) {
        return INVALID;
      } else {
        return compute(text, other, frame);
      }
    }

    private Object compute(String text, String other, Frame frame) {
      return switch (code) {
        case PredefinedType.INDEX_OF -> text.isEmpty() ? 0 : 1 + text.indexOf(other);
        case PredefinedType.LAST_INDEX_OF -> 1 + text.lastIndexOf(other);
        case PredefinedType.ENDS_WITH -> text.endsWith(other);
        case PredefinedType.STARTS_WITH -> text.startsWith(other);
        case PredefinedType.EQUALS_IGNORE_CASE -> text.equalsIgnoreCase(other);
        case PredefinedType.MATCHES -> matcher(frame, other, text).matches();
        case PredefinedType.TOKENIZE -> Limits.require(tokens(text, other, false));
        default -> joined(text, other);
      };
    }

    private static String joined(String text, String other) {
      Limits.requireCharacters((long) text.length() + other.length());
      return text.concat(other);
    }
  }

  /** An operation with two arguments. */
  public static final class Ternary extends Operation {
    private final Node first;
    private final Node second;

    public Ternary(int code, Node source, Node first, Node second) {
      super(code, source);
      this.first = first;
      this.second = second;
    }

    public static boolean has(int code) {
      return switch (code) {
        case PredefinedType.SUBSTRING,
            PredefinedType.REPLACE_ALL,
            PredefinedType.REPLACE_FIRST,
            PredefinedType.SUBSTITUTE_ALL,
            PredefinedType.SUBSTITUTE_FIRST,
            PredefinedType.TOKENIZE ->
            true;
        default -> false;
      };
    }

    @Override
    Object compute(String text, Frame frame) {
      Object one = first.evaluate(frame);
      Object two = second.evaluate(frame);
      if (isUndefined(one) || isUndefined(two)) {
        return INVALID;
      }
      return Limits.require(ternary(text, one, two, frame));
    }

    private Object ternary(String text, Object one, Object two, Frame frame) {
      return switch (code) {
        case PredefinedType.SUBSTRING -> substring(text, (Integer) one, (Integer) two);
        case PredefinedType.REPLACE_ALL ->
            matcher(frame, (String) one, text).replaceAll((String) two);
        case PredefinedType.REPLACE_FIRST ->
            matcher(frame, (String) one, text).replaceFirst((String) two);
        case PredefinedType.SUBSTITUTE_ALL -> substituteAll(text, (String) one, (String) two);
        case PredefinedType.SUBSTITUTE_FIRST -> substituteFirst(text, (String) one, (String) two);
        default -> tokens(text, (String) one, (Boolean) two);
      };
    }

    private static Object substring(String text, int first, int last) {
      boolean inside = 1 <= first && first <= last && last <= text.length();
      return inside ? text.substring(first - 1, last) : INVALID;
    }

    /** Replaces all occurrences; checks the length beforehand, since each step may double it. */
    private static String substituteAll(String text, String wanted, String replacement) {
      long growth = (long) replacement.length() - wanted.length();
      if (growth > 0 && (text.length() + 1L) * replacement.length() > Limits.MOST_CHARACTERS) {
        long times = occurrences(text, wanted);
        Limits.requireCharacters(text.length() + times * growth);
      }
      return text.replace(wanted, replacement);
    }

    private static long occurrences(String text, String wanted) {
      if (wanted.isEmpty()) {
        return text.length() + 1L;
      }
      long count = 0;
      for (int at = text.indexOf(wanted);
          at >= 0;
          at = text.indexOf(wanted, at + wanted.length())) {
        count++;
      }
      return count;
    }

    private static Object substituteFirst(String text, String wanted, String replacement) {
      int index = text.indexOf(wanted);
      return index < 0
          ? INVALID
          : text.substring(0, index) + replacement + text.substring(index + wanted.length());
    }
  }

  private static List<String> tokens(String text, String delimiters, boolean withDelimiters) {
    List<String> result = new ArrayList<>();
    StringTokenizer tokens = new StringTokenizer(text, delimiters, withDelimiters);
    while (tokens.hasMoreTokens()) {
      result.add(tokens.nextToken());
    }
    return result;
  }

  private static Matcher matcher(Frame frame, String expression, String text) {
    return matcher(frame.run, expression, text);
  }

  /** Returns a matcher of a regular expression for a text, within the time limit of the run. */
  static Matcher matcher(Run run, String expression, String text) {
    CharSequence watched = WatchedText.of(text, run);
    Matcher known = run.matchers().get(expression);
    if (known == null) {
      known = Pattern.compile(expression).matcher(watched);
      run.matchers().put(expression, known);
      return known;
    }
    return known.reset(watched);
  }

  /** {@code toString()} of any value, also of null and invalid. */
  public static final class ToString extends GuardedNode {
    private final Node source;

    public ToString(Node source) {
      this.source = source;
    }

    @Override
    Object compute(Frame frame) {
      Object value = source.evaluate(frame);
      if (value == null) {
        return "null";
      }
      return value == INVALID ? "invalid" : value.toString();
    }
  }
}

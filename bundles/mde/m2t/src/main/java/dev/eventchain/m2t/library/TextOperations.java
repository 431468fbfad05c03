package dev.eventchain.m2t.library;

import static dev.eventchain.m2t.library.OperationTable.Kind.ANY;
import static dev.eventchain.m2t.library.OperationTable.Kind.COLLECTION;
import static dev.eventchain.m2t.library.OperationTable.Kind.INTEGER;
import static dev.eventchain.m2t.library.OperationTable.Kind.SURELY_TEXT;
import static dev.eventchain.m2t.library.OperationTable.Kind.TEXT;

import dev.eventchain.m2t.library.OperationTable.Body;
import dev.eventchain.m2t.library.OperationTable.Kind;
import dev.eventchain.m2t.library.OperationTable.ResultType;
import dev.eventchain.m2t.library.OperationTable.Row;
import dev.eventchain.m2t.library.OperationTable.Types;
import dev.eventchain.m2t.text.Texts;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.StringTokenizer;
import java.util.function.IntPredicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Operations on strings and numbers. Positions count from 1; the position of a missing element is
 * -1.
 */
final class TextOperations {
  private static final ResultType TO_TEXT = Types::text;
  private static final ResultType TO_TRUTH = Types::truth;
  private static final ResultType TO_INTEGER = Types::integer;
  private static final ResultType TO_TEXTS = types -> types.language().sequenceOf(types.text());

  private TextOperations() {}

  static List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    addSums(rows);
    addTests(rows);
    addSubstitutions(rows);
    addParts(rows);
    addCases(rows);
    return rows;
  }

  /** Adds concatenations of a text and any value, in either order; null counts as empty text. */
  private static void addSums(List<Row> rows) {
    Body sum = (s, a, c) -> Texts.of(s) + Texts.of(a.get(0));
    for (Kind kind : List.of(ANY, COLLECTION)) {
      rows.add(new Row("+", SURELY_TEXT, List.of(kind), TO_TEXT, true, sum));
      rows.add(new Row("+", kind, List.of(SURELY_TEXT), TO_TEXT, true, sum));
    }
  }

  private static void addTests(List<Row> rows) {
    rows.add(row("contains", TO_TRUTH, (s, a, c) -> text(s).contains(text(a.get(0))), TEXT));
    rows.add(row("strstr", TO_TRUTH, (s, a, c) -> text(s).contains(text(a.get(0))), TEXT));
    rows.add(row("startsWith", TO_TRUTH, (s, a, c) -> text(s).startsWith(text(a.get(0))), TEXT));
    rows.add(row("endsWith", TO_TRUTH, (s, a, c) -> text(s).endsWith(text(a.get(0))), TEXT));
    rows.add(row("matches", TO_TRUTH, (s, a, c) -> matcher(s, a, c).matches(), TEXT));
    rows.add(row("isAlpha", TO_TRUTH, (s, a, c) -> all(s, Character::isLetter)));
    rows.add(row("isAlphanum", TO_TRUTH, (s, a, c) -> all(s, Character::isLetterOrDigit)));
    rows.add(row("strcmp", TO_INTEGER, (s, a, c) -> text(s).compareTo(text(a.get(0))), TEXT));
    rows.add(row("index", TO_INTEGER, (s, a, c) -> index(text(s).indexOf(text(a.get(0)))), TEXT));
    rows.add(
        row(
            "lastIndex",
            TO_INTEGER,
            (s, a, c) -> index(text(s).lastIndexOf(text(a.get(0)))),
            TEXT));
    addLaterPositions(rows);
  }

  /**
   * Adds searches with a second argument: the start position of the forward or backward search,
   * from 0.
   */
  private static void addLaterPositions(List<Row> rows) {
    rows.add(
        row(
            "index",
            TO_INTEGER,
            (s, a, c) -> index(text(s).indexOf(text(a.get(0)), number(a.get(1)))),
            TEXT,
            INTEGER));
    rows.add(
        row(
            "lastIndex",
            TO_INTEGER,
            (s, a, c) -> index(text(s).lastIndexOf(text(a.get(0)), number(a.get(1)))),
            TEXT,
            INTEGER));
  }

  private static void addSubstitutions(List<Row> rows) {
    Body first =
        (s, a, c) -> {
          Pattern literally = Pattern.compile(text(a.get(0)), Pattern.LITERAL);
          String replacement = Matcher.quoteReplacement(text(a.get(1)));
          return literally.matcher(text(s)).replaceFirst(replacement);
        };
    rows.add(row("substitute", TO_TEXT, first, TEXT, TEXT));
    rows.add(row("substituteFirst", TO_TEXT, first, TEXT, TEXT));
    rows.add(
        row(
            "substituteAll",
            TO_TEXT,
            (s, a, c) -> text(s).replace(text(a.get(0)), text(a.get(1))),
            TEXT,
            TEXT));
    rows.add(
        row(
            "replace",
            TO_TEXT,
            (s, a, c) -> matcher(s, a, c).replaceFirst(text(a.get(1))),
            TEXT,
            TEXT));
    rows.add(
        row(
            "replaceAll",
            TO_TEXT,
            (s, a, c) -> matcher(s, a, c).replaceAll(text(a.get(1))),
            TEXT,
            TEXT));
  }

  private static void addParts(List<Row> rows) {
    rows.add(row("tokenize", TO_TEXTS, (s, a, c) -> tokens(s, text(a.get(0))), TEXT));
    rows.add(row("tokenize", TO_TEXTS, (s, a, c) -> tokens(s, " \t\n\r\f")));
    rows.add(row("tokenizeLine", TO_TEXTS, (s, a, c) -> text(s).lines().toList()));
    rows.add(
        row(
            "strtok",
            TO_TEXT,
            (s, a, c) -> c.run().tokenWalk(text(s), number(a.get(1)) == 0).next(text(a.get(0))),
            TEXT,
            INTEGER));
    rows.add(
        row("first", TO_TEXT, (s, a, c) -> text(s).substring(0, length(s, a.get(0))), INTEGER));
    rows.add(
        row(
            "last",
            TO_TEXT,
            (s, a, c) -> text(s).substring(text(s).length() - length(s, a.get(0))),
            INTEGER));
    rows.add(row("substring", TO_TEXT, (s, a, c) -> from(text(s), number(a.get(0))), INTEGER));
    rows.add(row("prefix", TO_TEXT, (s, a, c) -> text(a.get(0)) + text(s), TEXT));
  }

  private static void addCases(List<Row> rows) {
    rows.add(row("trim", TO_TEXT, (s, a, c) -> text(s).trim()));
    for (String name : List.of("toUpperCase", "toUpper")) {
      rows.add(row(name, TO_TEXT, (s, a, c) -> text(s).toUpperCase(Locale.ROOT)));
    }
    for (String name : List.of("toLowerCase", "toLower")) {
      rows.add(row(name, TO_TEXT, (s, a, c) -> text(s).toLowerCase(Locale.ROOT)));
    }
    rows.add(row("toUpperFirst", TO_TEXT, (s, a, c) -> first(s, true)));
    rows.add(row("toLowerFirst", TO_TEXT, (s, a, c) -> first(s, false)));
    for (Kind kind : List.of(ANY, COLLECTION)) {
      rows.add(new Row("toString", kind, List.of(), TO_TEXT, true, (s, a, c) -> toText(s)));
    }
  }

  /** Returns the text of a value; that of null is not empty, as in Acceleo. */
  private static String toText(Object value) {
    return value == null ? "null" : Texts.of(value);
  }

  private static Row row(String name, ResultType result, Body body, Kind... arguments) {
    return new Row(name, TEXT, List.of(arguments), result, body);
  }

  /** Returns a matcher of the regular expression in the first argument on the text. */
  private static Matcher matcher(Object text, List<Object> arguments, OperationTable.Call call) {
    return call.run().pattern(text(arguments.get(0))).matcher(text(text));
  }

  private static String text(Object value) {
    return (String) value;
  }

  private static int number(Object value) {
    return ((Number) value).intValue();
  }

  private static int length(Object text, Object wanted) {
    int length = text(text).length();
    return number(wanted) < 0 ? length : Math.min(length, number(wanted));
  }

  private static String from(String text, int position) {
    if (position < 1 || position > text.length() + 1) {
      throw new IllegalArgumentException(
          "position " + position + " is not in a string of " + text.length() + " characters");
    }
    return text.substring(position - 1);
  }

  private static int index(int fromZero) {
    return fromZero < 0 ? -1 : fromZero + 1;
  }

  private static boolean all(Object value, IntPredicate test) {
    return text(value).codePoints().allMatch(test);
  }

  private static List<Object> tokens(Object value, String delimiters) {
    return delimiters.length() == 1
        ? tokens(text(value), delimiters.charAt(0))
        : Collections.list(new StringTokenizer(text(value), delimiters));
  }

  /**
   * Splits a text at a single delimiter, which is the frequent case, without visiting each
   * character.
   */
  private static List<Object> tokens(String text, char delimiter) {
    List<Object> tokens = new ArrayList<>(4);
    int start = 0;
    for (int end = text.indexOf(delimiter); end >= 0; end = text.indexOf(delimiter, start)) {
      if (end > start) {
        tokens.add(text.substring(start, end));
      }
      start = end + 1;
    }
    if (start < text.length()) {
      tokens.add(text.substring(start));
    }
    return tokens;
  }

  /** Returns an implementation for the first token only, or the last one. */
  static Optional<Body> endOnly(String operation, int arguments, boolean first) {
    return operation.equals("tokenize") && arguments == 1
        ? Optional.of((s, a, c) -> end(text(s), text(a.get(0)), first))
        : Optional.empty();
  }

  private static List<Object> end(String text, String delimiters, boolean first) {
    if (delimiters.length() != 1) {
      List<Object> all = tokens(text, delimiters);
      return all.isEmpty() ? all : List.of(all.get(first ? 0 : all.size() - 1));
    }
    char delimiter = delimiters.charAt(0);
    int start = 0;
    int end = text.length();
    while (start < end && text.charAt(start) == delimiter) {
      start++;
    }
    while (end > start && text.charAt(end - 1) == delimiter) {
      end--;
    }
    if (start == end) {
      return List.of();
    }
    if (first) {
      int next = text.indexOf(delimiter, start);
      return List.of(text.substring(start, next < 0 ? end : next));
    }
    return List.of(text.substring(Math.max(start, text.lastIndexOf(delimiter, end - 1) + 1), end));
  }

  private static String first(Object value, boolean upper) {
    String text = text(value);
    if (text.isEmpty()) {
      return text;
    }
    String first = text.substring(0, 1);
    String changed = upper ? first.toUpperCase(Locale.ROOT) : first.toLowerCase(Locale.ROOT);
    return changed + text.substring(1);
  }
}

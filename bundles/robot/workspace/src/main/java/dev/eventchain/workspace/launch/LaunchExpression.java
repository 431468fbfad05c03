package dev.eventchain.workspace.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Expressions of Python in launch files ({@code $(eval ...)}, {@code PythonExpression}), as far as
 * they compare, join and calculate with literals. Everything else, and what Python would refuse, is
 * not known; nothing is run.
 */
final class LaunchExpression {

  private static final Pattern TOKEN =
      Pattern.compile(
          "\\s*(?:('[^'\\\\\\n]*'|\"[^\"\\\\\\n]*\")|([0-9]+(?:\\.[0-9]*)?(?:[eE][-+]?[0-9]+)?|\\.[0-9]+)"
              + "|([A-Za-z_][A-Za-z_0-9]*)|(==|!=|<=|>=|//|[-+*/%<>()\\[\\],.]))");

  private static final int LONGEST = 10_000;
  private static final int DEEPEST = 50;

  private final List<String> tokens = new ArrayList<>();
  private int at;
  private int depth;

  private LaunchExpression(String text) {
    Matcher matcher = TOKEN.matcher(text);
    int end = 0;
    while (end < text.stripTrailing().length()) {
      if (text.length() > LONGEST || !matcher.region(end, text.length()).lookingAt()) {
        throw new LaunchValues.UnknownException();
      }
      tokens.add(matcher.group().strip());
      end = matcher.end();
    }
  }

  /** Returns the text of an expression's value, as Python writes it; empty if it is not known. */
  static Optional<String> value(String text) {
    try {
      LaunchExpression expression = new LaunchExpression(text);
      Object value = expression.choice();
      return expression.at < expression.tokens.size()
          ? Optional.empty()
          : Optional.of(LaunchValues.written(value));
    } catch (LaunchValues.UnknownException e) {
      return Optional.empty();
    }
  }

  private boolean take(String... words) {
    for (int i = 0; i < words.length; i++) {
      if (at + i >= tokens.size() || !tokens.get(at + i).equals(words[i])) {
        return false;
      }
    }
    at += words.length;
    return true;
  }

  private void need(String word) {
    if (!take(word)) {
      throw new LaunchValues.UnknownException();
    }
  }

  private Object choice() {
    if (++depth > DEEPEST) {
      throw new LaunchValues.UnknownException();
    }
    Object value = or();
    if (take("if")) {
      boolean holds = LaunchValues.truth(or());
      need("else");
      Object other = choice();
      value = holds ? value : other;
    }
    depth--;
    return value;
  }

  private Object or() {
    Object value = and();
    while (take("or")) {
      Object other = and();
      value = LaunchValues.truth(value) ? value : other;
    }
    return value;
  }

  private Object and() {
    Object value = not();
    while (take("and")) {
      Object other = not();
      value = LaunchValues.truth(value) ? other : value;
    }
    return value;
  }

  private Object not() {
    boolean odd = false;
    boolean any = false;
    while (take("not")) {
      odd = !odd;
      any = true;
    }
    Object value = comparison();
    return any ? (Object) (LaunchValues.truth(value) != odd) : value;
  }

  private Object comparison() {
    Object left = sum();
    Object result = null;
    for (Optional<String> operator = comparator(); operator.isPresent(); operator = comparator()) {
      Object right = sum();
      boolean holds = LaunchValues.compare(operator.get(), left, right);
      result = result == null ? holds : (Boolean) result && holds;
      left = right;
    }
    return result == null ? left : result;
  }

  private Optional<String> comparator() {
    if (take("not", "in")) {
      return Optional.of("not in");
    }
    for (String each : List.of("==", "!=", "<=", ">=", "<", ">", "in")) {
      if (take(each)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  private Object sum() {
    Object value = product();
    while (true) {
      if (take("+")) {
        Object other = product();
        value =
            value instanceof String one && other instanceof String two
                ? one + two
                : LaunchValues.calculated(value, other, Math::addExact, Double::sum);
      } else if (take("-")) {
        value =
            LaunchValues.calculated(value, product(), Math::subtractExact, (one, two) -> one - two);
      } else {
        return value;
      }
    }
  }

  private Object product() {
    Object value = sign();
    while (true) {
      if (take("*")) {
        value =
            LaunchValues.calculated(value, sign(), Math::multiplyExact, (one, two) -> one * two);
      } else if (take("/")) {
        double other = LaunchValues.number(sign()).doubleValue();
        value = LaunchValues.finite(LaunchValues.number(value).doubleValue() / other);
      } else if (take("//")) {
        value =
            LaunchValues.calculated(
                value, sign(), Math::floorDiv, (one, two) -> Math.floor(one / two));
      } else if (take("%")) {
        value = LaunchValues.calculated(value, sign(), Math::floorMod, (one, two) -> Double.NaN);
      } else {
        return value;
      }
    }
  }

  private Object sign() {
    boolean negative = false;
    boolean any = false;
    while (true) {
      if (take("-")) {
        negative = !negative;
      } else if (!take("+")) {
        break;
      }
      any = true;
    }
    Object value = called(atom());
    if (!any) {
      return value;
    }
    return LaunchValues.calculated(
        negative ? -1L : 1L, value, Math::multiplyExact, (one, two) -> one * two);
  }

  /** Returns what methods of a text give. */
  private Object called(Object value) {
    Object result = value;
    while (take(".")) {
      String method = tokens.get(Math.min(at++, tokens.size() - 1));
      need("(");
      List<Object> given = list(")");
      if (!(result instanceof String text)) {
        throw new LaunchValues.UnknownException();
      }
      result = LaunchValues.called(text, method, given);
    }
    return result;
  }

  private List<Object> list(String end) {
    List<Object> values = new ArrayList<>();
    while (!take(end)) {
      values.add(choice());
      if (!take(",")) {
        need(end);
        break;
      }
    }
    return values;
  }

  private Object atom() {
    if (take("(")) {
      Object value = choice();
      need(")");
      return value;
    } else if (take("[")) {
      return list("]");
    } else if (at >= tokens.size()) {
      throw new LaunchValues.UnknownException();
    }
    String token = tokens.get(at++);
    char first = token.charAt(0);
    if (first == '\'' || first == '"') {
      return texts(token);
    } else if (Character.isDigit(first) || first == '.') {
      return literal(token);
    }
    return switch (token) {
      case "True" -> true;
      case "False" -> false;
      case "str", "float", "int", "bool" -> converted(token);
      default -> throw new LaunchValues.UnknownException();
    };
  }

  /** Returns a text and those beside it as one. */
  private Object texts(String token) {
    StringBuilder text = new StringBuilder(token.substring(1, token.length() - 1));
    while (at < tokens.size() && "'\"".indexOf(tokens.get(at).charAt(0)) >= 0) {
      String next = tokens.get(at++);
      text.append(next, 1, next.length() - 1);
    }
    return text.toString();
  }

  private static Object literal(String token) {
    if (token.matches("0+|[1-9][0-9]{0,17}")) {
      return Long.valueOf(token);
    } else if (token.matches("[0-9]+")) {
      throw new LaunchValues
          .UnknownException(); // 010 is an error, and too long a number is not needed
    }
    return LaunchValues.finite(Double.parseDouble(token));
  }

  private Object converted(String function) {
    need("(");
    List<Object> given = list(")");
    if (given.size() != 1) {
      throw new LaunchValues.UnknownException();
    }
    return LaunchValues.converted(function, given.get(0));
  }
}

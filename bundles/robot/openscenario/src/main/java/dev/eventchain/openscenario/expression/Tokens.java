package dev.eventchain.openscenario.expression;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The words of an expression. */
final class Tokens {

  /** The end of an expression. */
  static final String END = "";

  private static final Pattern TOKEN =
      Pattern.compile(
          "\\s*(?:(\\$?[A-Za-z_]\\w*|(?:\\d+(?:\\.\\d*)?|\\.\\d+)(?:[eE][+-]?\\d+)?|[-+*/%(),])|(\\S))");

  private final List<String> tokens = new ArrayList<>();
  private int next;

  Tokens(String expression) throws ExpressionException {
    Matcher token = TOKEN.matcher(expression);
    while (token.lookingAt()) {
      if (token.group(2) != null) {
        throw new ExpressionException("`" + token.group(2) + "` does not belong in an expression.");
      }
      tokens.add(token.group(1));
      token.region(token.end(), expression.length());
    }
  }

  /** Returns the next word; {@link #END} at the end. */
  String peek() {
    return next < tokens.size() ? tokens.get(next) : END;
  }

  String take() {
    String token = peek();
    next++;
    return token;
  }

  /** Takes the next word if it is one of some. */
  boolean takes(String word) {
    boolean there = peek().equals(word);
    if (there) {
      next++;
    }
    return there;
  }

  void expect(String word) throws ExpressionException {
    if (!takes(word)) {
      throw new ExpressionException("`" + word + "` is missing " + before() + ".");
    }
  }

  /** Returns where the next word is, for a sentence. */
  String before() {
    return peek().equals(END) ? "at the end" : "before `" + peek() + "`";
  }
}

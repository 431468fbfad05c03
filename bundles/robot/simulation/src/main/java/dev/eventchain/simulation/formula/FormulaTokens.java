package dev.eventchain.simulation.formula;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Tokens of a formula, in sequence. */
public final class FormulaTokens {

  /** Limit on nested parentheses, which keeps the parser from a stack overflow. */
  private static final int MOST = 300;

  private static final Pattern TOKEN =
      Pattern.compile(
          "(?<number>[0-9]+(?:\\.[0-9]+)?(?:[eE][-+]?[0-9]+)?)"
              + "|(?<word>[A-Za-z_]\\w*(?:\\.[A-Za-z_]\\w*)*)"
              + "|(?<text>'[^'\\n]*'|\"[^\"\\n]*\")"
              + "|(?<sign><=|>=|<>|==|!=|[=<>+*/()\\[\\],-])");

  /** A field of a topic; matched only where no operand precedes it, or it would be a division. */
  private static final Pattern TOPIC = Pattern.compile("(?:/[A-Za-z_]\\w*)+(?:\\.[A-Za-z_]\\w*)+");

  /** An output by the requirement that it satisfies, and its unit or type. */
  static final Pattern OUTPUT =
      Pattern.compile("output\\s*\\(\\s*(?<id>[^(),\\s]+)\\s*(?:,\\s*(?<kind>[^(),\\s]+)\\s*)?\\)");

  /**
   * A quantity of an actor, such as {@code actor('walker').gap}, or of an event of a storyboard,
   * such as {@code event('braking').started}.
   */
  static final Pattern ACTOR =
      Pattern.compile(
          "(?<of>actor|event)\\s*\\(\\s*(?:'(?<name>[^']*)'|\"(?<other>[^\"]*)\")\\s*\\)\\s*\\.\\s*(?<part>\\w+)");

  /**
   * A unit, without blanks in its division, such as {@code m/s}, {@code %/s} or {@code 1/s}; blanks
   * may separate it from its number.
   */
  private static final Pattern UNIT =
      Pattern.compile(
          "\\s*((?:1(?=/[A-Za-z])|%|\u00b0|[A-Za-z]\\w*(?:\\^[0-9]+)?)(?:/[A-Za-z]\\w*(?:\\^[0-9]+)?)*)");

  enum Kind {
    NUMBER,
    UNIT,
    WORD,
    TEXT,
    SIGN,
    END
  }

  /** A token with its offsets in the text. */
  record Token(Kind kind, String text, int start, int end) {}

  /** Places of formulas, with the rules of their problems. */
  @SuppressWarnings("ImmutableEnumChecker") // rules are immutable
  enum Place {
    SCENARIO(
        FormulaRules.SCENARIO_FORMULA_SYNTAX,
        FormulaRules.SCENARIO_FORMULA_UNIT,
        FormulaRules.SCENARIO_FORMULA_SIGNAL),
    BENCH(
        FormulaRules.BENCH_FORMULA_SYNTAX,
        FormulaRules.BENCH_FORMULA_UNIT,
        FormulaRules.BENCH_FORMULA_SIGNAL);

    private final Rule syntax;
    private final Rule unit;
    private final Rule signal;

    Place(Rule syntax, Rule unit, Rule signal) {
      this.syntax = syntax;
      this.unit = unit;
      this.signal = signal;
    }
  }

  private final Place place;
  private final SourceText source;
  private final List<Token> tokens = new ArrayList<>();
  private int position;

  FormulaTokens(SourceRange range, Place place) {
    this.place = place;
    this.source = range.source();
    SourceRange inner = range.strip();
    Matcher token = TOKEN.matcher(source.text()).region(inner.start(), inner.end());
    int at = inner.start();
    while (at < inner.end()) {
      at = read(token, at, inner.end());
    }
    tokens.add(new Token(Kind.END, "", inner.end(), inner.end()));
    if (tokens.size() > MOST) {
      throw syntax(tokens.get(MOST), "The formula is too long.", "Split it at an `and`.");
    }
  }

  private int read(Matcher token, int at, int end) {
    if (Character.isWhitespace(source.text().charAt(at))) {
      return at + 1;
    }
    Matcher topic = TOPIC.matcher(source.text()).region(at, end);
    if (!afterOperand() && topic.lookingAt()) {
      tokens.add(new Token(Kind.WORD, topic.group(), at, topic.end()));
      return topic.end();
    }
    for (Pattern call : List.of(OUTPUT, ACTOR)) {
      Matcher named = call.matcher(source.text()).region(at, end);
      if (!afterOperand() && named.lookingAt()) {
        tokens.add(new Token(Kind.WORD, named.group(), at, named.end()));
        return named.end();
      }
    }
    token.region(at, end);
    if (!token.lookingAt()) {
      String character = new String(Character.toChars(source.text().codePointAt(at)));
      Token wrong = new Token(Kind.SIGN, character, at, at + character.length());
      throw syntax(wrong, "Formulas have no '" + character + "'.", "");
    }
    Kind kind = kind(token);
    tokens.add(new Token(kind, token.group(), at, token.end()));
    return kind == Kind.NUMBER ? unit(token.end(), end) : token.end();
  }

  private static Kind kind(Matcher token) {
    if (token.group("number") != null) {
      return Kind.NUMBER;
    }
    return token.group("word") != null
        ? Kind.WORD
        : token.group("text") != null ? Kind.TEXT : Kind.SIGN;
  }

  /** Returns whether a text is a valid name in formulas. */
  public static boolean isName(String text) {
    return text.matches("[A-Za-z_]\\w*(?:\\.[A-Za-z_]\\w*)*") && !Operator.KEYWORDS.contains(text);
  }

  private boolean afterOperand() {
    if (tokens.isEmpty()) {
      return false;
    }
    Token last = tokens.get(tokens.size() - 1);
    return last.kind() == Kind.SIGN
        ? last.text().equals(")")
        : !Operator.KEYWORDS.contains(last.text());
  }

  private int unit(int at, int end) {
    Matcher unit = UNIT.matcher(source.text()).region(at, end);
    if (!unit.lookingAt() || Operator.KEYWORDS.contains(unit.group(1))) {
      return at;
    }
    tokens.add(new Token(Kind.UNIT, unit.group(1), unit.start(1), unit.end()));
    return unit.end();
  }

  Token peek() {
    return tokens.get(position);
  }

  /** Returns the token after the next one. */
  Token second() {
    return tokens.get(Math.min(position + 1, tokens.size() - 1));
  }

  Token next() {
    Token token = peek();
    if (token.kind() != Kind.END) {
      position++;
    }
    return token;
  }

  /** Returns the number of tokens that were read. */
  int position() {
    return position;
  }

  boolean nextIs(String text) {
    Token token = peek();
    return token.text().equals(text) && (token.kind() == Kind.WORD || token.kind() == Kind.SIGN);
  }

  boolean take(String text) {
    boolean is = nextIs(text);
    if (is) {
      next();
    }
    return is;
  }

  void require(String text, String hint) {
    Token token = peek();
    if (!take(text)) {
      throw syntax(token, "Expected '" + text + "', but found " + shown(token) + ".", hint);
    }
  }

  /** Returns whether the tokens read since a position are enclosed in one pair of parentheses. */
  boolean enclosedSince(int start) {
    int depth = 0;
    for (int i = start; i < position; i++) {
      depth += tokens.get(i).text().equals("(") ? 1 : tokens.get(i).text().equals(")") ? -1 : 0;
      if (depth == 0) {
        return i == position - 1 && i > start;
      }
    }
    return false;
  }

  /** Returns the text read since a token, on one line. */
  String textSince(Token first) {
    int end = tokens.get(position - 1).end();
    return FormulaParser.plain(source.text().substring(first.start(), end));
  }

  static String shown(Token token) {
    return switch (token.kind()) {
      case END -> "the end of the formula";
      case TEXT -> token.text();
      default -> "'" + token.text() + "'";
    };
  }

  DiagnosticException syntax(Token token, String message, String hint) {
    return problem(place.syntax, token, message, hint);
  }

  DiagnosticException unitProblem(Token token, String message, String hint) {
    return problem(place.unit, token, message, hint);
  }

  DiagnosticException constant(Token token, String message, String hint) {
    return problem(FormulaRules.SCENARIO_FORMULA_CONSTANT, token, message, hint);
  }

  DiagnosticException unknownSignal(Token token, String message, String hint) {
    return problem(place.signal, token, message, hint);
  }

  private DiagnosticException problem(Rule rule, Token token, String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(rule, message, source.at(token.start())).withHint(hint));
  }
}

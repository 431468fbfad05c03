package dev.eventchain.ocl.parse;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.text.ExpressionRules;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Finds constructs of other languages or other editions of OCL, which do not parse. The parser
 * stops at the first error; this finds all, with their replacements.
 */
public final class FrequentMistakes {

  private record Mistake(String message, String hint) {}

  /** Mistakes by pairs of adjacent characters. */
  private static final Map<String, Mistake> OPERATORS =
      Map.ofEntries(
          Map.entry("==", new Mistake("OCL has no operator '=='.", "Equality is written =.")),
          Map.entry("!=", new Mistake("OCL has no operator '!='.", "Inequality is written <>.")),
          Map.entry("&&", new Mistake("OCL has no operator '&&'.", "Write and.")),
          Map.entry("||", new Mistake("OCL has no operator '||'.", "Write or.")),
          Map.entry(
              "=>",
              new Mistake("OCL has no operator '=>'.", "Write implies, or >= for a comparison.")),
          Map.entry(
              ":=", new Mistake("'=' is written without a colon.", "Nothing is assigned in OCL.")),
          Map.entry("=<", new Mistake("OCL has no operator '=<'.", "Write <=.")),
          Map.entry("=~", new Mistake("OCL has no operator '=~'.", "Write text.matches('...').")),
          Map.entry(
              "//", new Mistake("Comments start with two hyphens.", "Write -- instead of //.")),
          Map.entry(
              "^^",
              new Mistake(
                  "'^^' is not part of this OCL.", "A model in a file sends no messages.")));

  private static final Map<String, Mistake> CHARACTERS =
      Map.of(
          "!", new Mistake("OCL has no operator '!'.", "Write not."),
          "%", new Mistake("OCL has no operator '%'.", "Write a.mod(b)."),
          "^", new Mistake("'^' is not an operator on numbers.", "Multiply."),
          "#", new Mistake("'#' is not written before a literal.", "Write Type::LITERAL."),
          "?", new Mistake("OCL has no operator '?'.", "Write if ... then ... else ... endif."));

  private static final Set<String> INFIX =
      Set.of("mod", "div", "max", "min", "concat", "AND", "OR", "XOR", "IMPLIES");
  private static final Set<String> KEYWORDS =
      Set.of(
          "and", "or", "xor", "not", "implies", "if", "then", "else", "endif", "let", "in", "inv",
          "def");

  /** The names that may have a bar inside their parentheses. */
  public static final Set<String> ITERATORS =
      Set.of(
          "forAll",
          "exists",
          "select",
          "reject",
          "collect",
          "collectNested",
          "any",
          "one",
          "isUnique",
          "sortedBy",
          "closure",
          "iterate");

  private static final Set<String> CONDITIONAL = Set.of("if", "elseif", "else", "endif");

  private static final String NO_ELSE =
      "Write if ... then ... else ... endif, or in a constraint: condition implies ...";

  private static final Mistake QUOTED_SELF =
      new Mistake("_'self' is read as self, whatever has that name.", "Write self._'self'.");

  private final SourceRange range;
  private final Tokens tokens;
  private final Nesting nesting;
  private final List<Diagnostic> found = new ArrayList<>();

  /** For each if that is not closed yet, whether its last part is an else. */
  private final Deque<Boolean> hasElse = new ArrayDeque<>();

  private int at;

  private FrequentMistakes(SourceRange range) {
    this.range = range;
    this.tokens = new Tokens(range.text());
    this.nesting = new Nesting(tokens);
  }

  /** Returns the mistakes in a part of a text, each an error at its place. */
  public static List<Diagnostic> in(SourceRange range) {
    FrequentMistakes mistakes = new FrequentMistakes(range);
    int comment = mistakes.tokens.unclosedComment();
    if (comment >= 0) {
      SourceLocation place = range.source().at(range.start() + comment);
      mistakes.found.add(Diagnostic.of(ExpressionRules.SYNTAX, "This comment has no end.", place));
    }
    while (mistakes.at < mistakes.tokens.size()) {
      mistakes.look();
    }
    return mistakes.found;
  }

  private void look() {
    String token = tokens.text(at);
    String pair = tokens.touches(at) ? token + tokens.text(at + 1) : "";
    if (OPERATORS.containsKey(pair)) {
      add(at, OPERATORS.get(pair));
      at += 2;
      skipRestOfLine(pair);
      return;
    } else if (CHARACTERS.containsKey(token) && !SafeDots.SIGNS.contains(pair)) {
      add(at, CHARACTERS.get(token));
    } else if ("'\"".indexOf(token.charAt(0)) >= 0 && !tokens.isString(at)) {
      add(at, unclosed(token));
    } else if (token.equals("[") && endsOperand(at - 1)) {
      add(at, new Mistake("Brackets select no element here.", "Write ->at(1) for the first."));
    } else if (token.equals(";") && nesting.depth(at) == 0) {
      add(at, new Mistake("';' does not end an expression.", "Leave it out."));
    } else if (INFIX.contains(token) && endsOperand(at - 1) && startsOperand(at + 1)) {
      add(at, infix(token));
    } else if (CONDITIONAL.contains(token) && !(at > 0 && tokens.is(at - 1, "."))) {
      lookAtConditional(token);
    } else if (isQuotedSelf()) {
      add(at, QUOTED_SELF);
    } else if (token.equals("->")) {
      lookAtArrow();
    } else if (token.equals(".") && isIteration(at + 1)) {
      add(at, dotted(tokens.text(at + 1)));
    }
    at++;
  }

  private static Mistake dotted(String iteration) {
    return new Mistake("'" + iteration + "' follows an arrow.", "Write -> instead of the dot.");
  }

  private void lookAtConditional(String token) {
    if (token.equals("if")) {
      hasElse.push(false);
    } else if (!hasElse.isEmpty()) {
      boolean before = hasElse.pop();
      if (token.equals("endif") && !before) {
        add(at, new Mistake("This if has no else, so it has no value otherwise.", NO_ELSE));
      } else if (!token.equals("endif")) {
        hasElse.push(token.equals("else"));
      }
    }
  }

  private boolean isQuotedSelf() {
    return tokens.is(at, "_")
        && tokens.is(at + 1, "'self'")
        && !(at > 0 && (tokens.is(at - 1, ".") || tokens.is(at - 1, "::")));
  }

  private static Mistake unclosed(String token) {
    if (token.startsWith("\"")) {
      return new Mistake("Strings are written in single quotes.", "Write '...'.");
    }
    return new Mistake(
        "The string is not closed.",
        token.endsWith("\\'")
            ? "\\' is a quote inside it; a backslash is written \\\\."
            : "A string ends on its line with '.");
  }

  private void skipRestOfLine(String pair) {
    if (pair.equals("//")) {
      int line = location(at - 1).line();
      while (at < tokens.size() && location(at).line() == line) {
        at++;
      }
    }
  }

  private static Mistake infix(String word) {
    return Character.isUpperCase(word.charAt(0))
        ? new Mistake("'" + word + "' is written in lower case.", "")
        : new Mistake("'" + word + "' is not an infix operator.", "Write a." + word + "(b).");
  }

  private void lookAtArrow() {
    boolean lambda = at > 2 && tokens.is(at - 2, "(") && ITERATORS.contains(tokens.text(at - 3));
    if (lambda && tokens.isName(at - 1) && !tokens.is(at + 2, "(")) {
      add(
          at,
          new Mistake("'->' does not follow a variable's declaration.", "Write a bar: x | ..."));
    } else if (!tokens.isName(at + 1)) {
      add(at, new Mistake("The name of an operation is missing after '->'.", ""));
    } else if (!tokens.is(at + 2, "(")) {
      String name = tokens.text(at + 1);
      add(
          at,
          new Mistake(
              "'->' is followed by the name of an operation and parentheses.",
              "Write ." + name + " for a feature, ->" + name + "() for an operation."));
    } else if (isIteration(at + 1) && !ITERATORS.contains(tokens.text(at + 1))) {
      String name = tokens.text(at + 1);
      add(
          at + 1,
          new Mistake(
              "There is no iterator '" + name + "'.", NearestName.question(name, ITERATORS)));
    } else if (ITERATORS.contains(tokens.text(at + 1)) && !isIteration(at + 1)) {
      lookForColon();
    }
  }

  /** Finds {@code forAll(x : x.ok)}, with a colon in place of the bar. */
  private void lookForColon() {
    if (tokens.isName(at + 3) && tokens.is(at + 4, ":")) {
      add(at + 4, new Mistake("A bar separates the variable from the body.", "Write x | ..."));
    }
  }

  /** Returns whether a name is followed by parentheses with a bar directly inside. */
  private boolean isIteration(int name) {
    return tokens.isName(name) && nesting.hasBar(name + 1);
  }

  private boolean endsOperand(int index) {
    return index >= 0
        && (isOperandWord(index)
            || tokens.is(index, "endif")
            || tokens.isString(index)
            || Nesting.closes(tokens, index));
  }

  private boolean startsOperand(int index) {
    return isOperandWord(index)
        || tokens.isString(index)
        || tokens.is(index, "(")
        || tokens.is(index, "not")
        || tokens.is(index, "if");
  }

  private boolean isOperandWord(int index) {
    return index < tokens.size()
        && Character.isJavaIdentifierPart(tokens.text(index).charAt(0))
        && !KEYWORDS.contains(tokens.text(index));
  }

  private void add(int token, Mistake mistake) {
    found.add(
        Diagnostic.of(ExpressionRules.SYNTAX, mistake.message(), location(token))
            .withHint(mistake.hint()));
  }

  private SourceLocation location(int token) {
    return range.source().at(range.start() + tokens.start(token));
  }
}

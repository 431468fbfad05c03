package dev.eventchain.simulation.formula;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.simulation.formula.FormulaTokens.Kind;
import dev.eventchain.simulation.formula.FormulaTokens.Token;
import java.util.Map;
import java.util.Optional;

/**
 * Parses the conditions of a formula. From loose to tight: {@code implies} (right-associative),
 * {@code or}, {@code and}, {@code until} and {@code since}, prefix operators, comparisons; {@link
 * TermParser} reads the rest.
 */
public final class FormulaParser {

  /**
   * A part of a formula, a {@link Condition} or a {@link Term}; either may stand in parentheses.
   */
  public interface Part {}

  private static final Map<String, String> NO_EQUALITY =
      Map.of("=", "<=", "==", "<=", "<>", ">", "!=", ">");

  private final FormulaTokens tokens;
  private final TermParser terms;
  private final IntervalParser intervals;

  private final Optional<Range.Source> ranges;

  private FormulaParser(
      SourceRange range,
      FormulaTokens.Place place,
      Signal.Source signals,
      double duration,
      Optional<Range.Source> ranges) {
    this.ranges = ranges;
    this.tokens = new FormulaTokens(range, place);
    this.terms = new TermParser(tokens, signals, duration, this::part, this::condition);
    this.intervals = new IntervalParser(tokens, duration);
  }

  /**
   * Parses a formula.
   *
   * @param ranges the values of signals, to find what cannot be otherwise; empty to allow that
   */
  static Condition parse(
      SourceRange range, Signal.Source signals, double duration, Optional<Range.Source> ranges) {
    FormulaTokens.Place place = FormulaTokens.Place.SCENARIO;
    return (Condition) new FormulaParser(range, place, signals, duration, ranges).formula(true);
  }

  /** Parses a quantity or a condition of the bench, which has no temporal operators. */
  public static Part parseMoment(SourceRange range, Signal.Source signals) {
    return new FormulaParser(range, FormulaTokens.Place.BENCH, signals, 0, Optional.empty())
        .moment(false, "Only what holds at one moment can be sent.");
  }

  /** Parses a condition of a scenario that is true or false at each moment. */
  static Condition parseCircumstance(SourceRange range, Signal.Source signals) {
    return (Condition)
        new FormulaParser(range, FormulaTokens.Place.SCENARIO, signals, 0, Optional.empty())
            .moment(true, "Only what holds at one moment can be waited for.");
  }

  /** Parses a quantity of one moment, which is neither true nor false. */
  static Term parseQuantity(SourceRange range, Signal.Source signals) {
    FormulaParser parser =
        new FormulaParser(range, FormulaTokens.Place.SCENARIO, signals, 0, Optional.empty());
    Token first = parser.tokens.peek();
    Part part = parser.formula(false);
    if (part instanceof Term term) {
      return term;
    }
    throw parser.tokens.syntax(first, "This is true or false, and not a quantity.", "");
  }

  private Part moment(boolean isCondition, String refusal) {
    Token first = tokens.peek();
    Part part = formula(isCondition);
    if (part instanceof Condition condition && !condition.ofOneMoment()) {
      throw tokens.syntax(first, refusal, "Leave out operators such as `always`.");
    }
    return part;
  }

  /** Returns a text on one line. */
  static String plain(String text) {
    return text.strip().replaceAll("\\s+", " ");
  }

  private Part formula(boolean isCondition) {
    Token first = tokens.peek();
    if (first.kind() == Kind.END) {
      throw tokens.syntax(
          first, "The formula is empty.", "Write, for example, `always gap > 1 m`.");
    }
    Part part = part();
    Part formula = isCondition ? condition(part, first) : part;
    Token rest = tokens.peek();
    if (tokens.nextIs(")") || tokens.nextIs("]")) {
      throw tokens.syntax(rest, "There is nothing for '" + rest.text() + "' to close.", "");
    }
    if (rest.kind() != Kind.END) {
      String message = "Expected the end of the formula, but found " + FormulaTokens.shown(rest);
      throw tokens.syntax(
          rest,
          message + ".",
          rest.text().matches("until|since") ? CHAINED.formatted(rest.text()) : "");
    }
    if (formula instanceof Condition condition) {
      intervals.requireReached(condition);
      ranges.ifPresent(known -> requireVarying(condition, known, first));
      if (ranges.isPresent()) {
        intervals.requireLong(condition);
        requireSomethingBefore(condition, first);
      }
    }
    terms.requireResolved();
    return formula;
  }

  /** Rejects operators about the past that are judged at the start, before which there is none. */
  private void requireSomethingBefore(Condition condition, Token first) {
    if (condition instanceof Past.Temporal || condition instanceof Past.Since) {
      throw tokens.syntax(
          first,
          "Nothing comes before the start of the run, at which this is judged.",
          "Say when it has to hold: `always (brake > 0 implies once[0,1] gap < 20 m)`.");
    }
    if (!(condition instanceof Condition.Temporal) && !(condition instanceof Condition.Until)) {
      condition.parts().forEach(part -> requireSomethingBefore(part, first));
    }
  }

  private static final String CHAINED = "Put what is before this `%s` into parentheses.";

  private Condition condition(Part part, Token first) {
    if (part instanceof Condition condition) {
      return condition;
    }
    if (part instanceof Term term && term.truth()) {
      return Condition.Comparison.isTrue(term, tokens.textSince(first));
    }
    throw tokens.syntax(
        first,
        "'" + tokens.textSince(first) + "' is a quantity, not true or false.",
        "Compare it with another quantity by <, <=, > or >=.");
  }

  private Term term(Part part, Token first) {
    if (part instanceof Term term) {
      return term;
    }
    throw tokens.syntax(
        first, "'" + tokens.textSince(first) + "' is true or false, not a quantity.", "");
  }

  private Part part() {
    Token first = tokens.peek();
    Part left = alternatives();
    if (!tokens.nextIs("implies")) {
      return left;
    }
    Condition premise = condition(left, first);
    String text = tokens.textSince(first);
    tokens.next();
    Token second = tokens.peek();
    return new Condition.Implication(premise, condition(part(), second), text);
  }

  private Part alternatives() {
    Token first = tokens.peek();
    Part left = conjunction();
    while (tokens.nextIs("or")) {
      Condition before = condition(left, first);
      String text = tokens.textSince(first);
      tokens.next();
      Token second = tokens.peek();
      left = alternative(before, text, condition(conjunction(), second), second);
    }
    return left;
  }

  /**
   * Parses {@code or}; {@code not p or q} counts as {@code p implies q}, which is vacuous without
   * p.
   */
  private Condition alternative(Condition before, String text, Condition after, Token second) {
    boolean isPremise = before instanceof Condition.Negation;
    if (isPremise == after instanceof Condition.Negation) {
      return new Condition.Junction(false, before, after);
    }
    String negated = isPremise ? text : tokens.textSince(second);
    Condition.Negation negation = (Condition.Negation) (isPremise ? before : after);
    return new Condition.Implication(
        negation.operand(), isPremise ? after : before, negated.replaceFirst("^not\\s*", ""));
  }

  private Part conjunction() {
    Token first = tokens.peek();
    Part left = until();
    while (tokens.nextIs("and")) {
      Condition before = condition(left, first);
      tokens.next();
      Token second = tokens.peek();
      left = new Condition.Junction(true, before, condition(until(), second));
    }
    return left;
  }

  private Part until() {
    Token first = tokens.peek();
    Part left = prefixed();
    if (!tokens.nextIs("until") && !tokens.nextIs("since")) {
      return left;
    }
    Condition kept = condition(left, first);
    boolean past = tokens.next().text().equals("since");
    Interval interval = intervals.parse();
    Token second = tokens.peek();
    Condition reached = condition(prefixed(), second);
    return past
        ? new Past.Since(kept, interval, reached)
        : new Condition.Until(kept, interval, reached);
  }

  private Part prefixed() {
    Token first = tokens.peek();
    if (first.kind() != Kind.WORD) {
      return comparison();
    }
    return switch (first.text()) {
      case "not" -> {
        tokens.next();
        Token operand = tokens.peek();
        yield new Condition.Negation(condition(prefixed(), operand));
      }
      case "always", "eventually", "historically", "once" -> temporal(tokens.next());
      case "rise" -> new Condition.Rise(edgeOf(tokens.next()));
      case "fall" -> new Condition.Rise(new Condition.Negation(edgeOf(tokens.next())));
      default -> comparison();
    };
  }

  private Condition edgeOf(Token operator) {
    String hint = "Write, for example, `" + operator.text() + "(brake > 0)`.";
    tokens.require("(", hint);
    Token first = tokens.peek();
    Condition operand = condition(part(), first);
    tokens.require(")", "");
    return operand;
  }

  /**
   * Parses a temporal operator, whose operand needs parentheses since its reach is ambiguous
   * otherwise.
   */
  private Condition temporal(Token operator) {
    Interval interval = intervals.parse();
    int start = tokens.position();
    Token first = tokens.peek();
    Condition operand = condition(prefixed(), first);
    boolean clear =
        operand instanceof Condition.Temporal
            || operand instanceof Past.Temporal
            || operand instanceof Condition.Rise
            || tokens.enclosedSince(start);
    Token next = tokens.peek();
    boolean goesOn =
        tokens.nextIs("and")
            || tokens.nextIs("or")
            || tokens.nextIs("implies")
            || tokens.nextIs("until")
            || tokens.nextIs("since");
    if (goesOn && !clear) {
      throw tokens.syntax(
          next,
          "It is not clear whether '" + operator.text() + "' reaches beyond this.",
          "Put all that it reaches into parentheses.");
    }
    return switch (operator.text()) {
      case "always" -> new Condition.Temporal(true, interval, operand);
      case "eventually" -> new Condition.Temporal(false, interval, operand);
      case "historically" -> new Past.Temporal(true, interval, operand);
      default -> new Past.Temporal(false, interval, operand);
    };
  }

  private Part comparison() {
    Token first = tokens.peek();
    Part left = terms.sum();
    Token relation = tokens.peek();
    if (!isRelation(relation)) {
      return left;
    }
    Term before = term(left, first);
    tokens.next();
    Token second = tokens.peek();
    Term after = term(terms.sum(), second);
    terms.requireSameDimension(before, after, second);
    String text = tokens.textSince(first);
    if (isRelation(tokens.peek())) {
      throw tokens.syntax(tokens.peek(), "Comparisons cannot be chained.", "Join two by `and`.");
    }
    boolean strict = relation.text().length() == 1;
    Condition.Comparison comparison =
        relation.text().startsWith("<")
            ? new Condition.Comparison(before, after, strict, text)
            : new Condition.Comparison(after, before, strict, text);
    ranges.ifPresent(known -> requireVarying(comparison, known, first));
    return comparison;
  }

  /** Rejects what is true or false in every run. */
  private void requireVarying(Condition condition, Range.Source known, Token first) {
    Optional<Boolean> always = Constancy.of(condition, known);
    if (always.isPresent()) {
      throw tokens.constant(
          first,
          "'%s' is %s in every run.".formatted(plain(tokens.textSince(first)), always.get()),
          condition instanceof Condition.Comparison comparison
              ? comparison.values(known)
              : "Leave out what makes it so, or say what could be otherwise.");
    }
  }

  private boolean isRelation(Token token) {
    if (token.kind() != Kind.SIGN) {
      return false;
    }
    String better = NO_EQUALITY.get(token.text());
    if (better != null) {
      throw tokens.syntax(
          token,
          "Measured quantities are hardly ever equal, so there is no '" + token.text() + "'.",
          "Allow a tolerance: `abs(a - b) " + better + " 0.1 m`.");
    }
    return token.text().startsWith("<") || token.text().startsWith(">");
  }
}

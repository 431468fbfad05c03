package dev.eventchain.simulation.formula;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.formula.FormulaParser.Part;
import dev.eventchain.simulation.formula.FormulaTokens.Kind;
import dev.eventchain.simulation.formula.FormulaTokens.Token;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.stream.Collectors;

/** Parses the quantities of a formula, and checks their units. */
final class TermParser {

  private static final double STEP = World.seconds(World.TRACE_STEP);
  private static final Term SECOND = Term.number(1, Unit.parse("s").orElseThrow(), "s");

  private final FormulaTokens tokens;
  private final Signal.Source signals;
  private final Supplier<Part> parenthesized;
  private final BiFunction<Part, Token, Condition> conditions;
  private final double longest;
  private final NamedValueParser names;
  private Optional<UnresolvedOutputException> unresolved = Optional.empty();

  /**
   * Creates a parser of quantities.
   *
   * @param longest of the scenario, in s; 0 if only one moment is known
   * @param parenthesized parses the content of parentheses, which need not be a quantity
   * @param conditions returns a part that begins at a token as a condition
   */
  TermParser(
      FormulaTokens tokens,
      Signal.Source signals,
      double longest,
      Supplier<Part> parenthesized,
      BiFunction<Part, Token, Condition> conditions) {
    this.longest = longest;
    this.conditions = conditions;
    this.tokens = tokens;
    this.names = new NamedValueParser(tokens);
    this.signals = signals;
    this.parenthesized = parenthesized;
  }

  /** Parses a sum, or a condition in parentheses. */
  Part sum() {
    Token first = tokens.peek();
    Part left = product();
    while (tokens.nextIs("+") || tokens.nextIs("-")) {
      Term before = term(left, first);
      boolean plus = tokens.next().text().equals("+");
      Token second = tokens.peek();
      Term after = term(product(), second);
      requireSameDimension(before, after, second);
      left = plus ? before.plus(after) : before.minus(after);
    }
    return left;
  }

  private Part product() {
    Token first = tokens.peek();
    Part left = negative();
    while (tokens.nextIs("*") || tokens.nextIs("/")) {
      Term before = term(left, first);
      int power = tokens.next().text().equals("*") ? 1 : -1;
      Token second = tokens.peek();
      left = before.times(term(negative(), second), power);
    }
    return left;
  }

  private Part negative() {
    if (!tokens.take("-")) {
      return primary();
    }
    Token first = tokens.peek();
    return term(negative(), first).negative();
  }

  private Part primary() {
    Token token = tokens.next();
    if (token.kind() == Kind.NUMBER) {
      return number(token);
    }
    if (token.kind() == Kind.SIGN && token.text().equals("(")) {
      Part inner = parenthesized.get();
      tokens.require(")", "");
      return inner;
    }
    if (token.kind() == Kind.WORD) {
      return switch (token.text()) {
        case "if" -> conditional(token);
        case "derivative" -> derivative(token);
        case "abs" -> absolute();
        case "ceil" -> ceiling();
        case "min" -> extreme(false);
        case "max" -> extreme(true);
        default -> signal(token);
      };
    }
    String found = FormulaTokens.shown(token);
    throw tokens.syntax(
        token,
        "Expected a quantity or a condition, but found " + found + ".",
        token.kind() == Kind.TEXT ? "Names of values stand after a signal and `==` or `!=`." : "");
  }

  private Term number(Token token) {
    double value = Double.parseDouble(token.text());
    if (Double.isInfinite(value)) {
      throw tokens.syntax(token, "The number " + token.text() + " is too large.", "");
    }
    if (tokens.peek().kind() != Kind.UNIT) {
      return Term.number(value, unit("1", token), "1");
    }
    Token unit = tokens.next();
    return Term.number(value, unit(unit.text(), unit), unit.text());
  }

  private Unit unit(String text, Token token) {
    Optional<Unit> unit = Unit.parse(text);
    if (unit.isEmpty()) {
      String hint = NearestName.hint(text, Unit.common());
      String blanks = text.contains("/") ? " Any other division needs spaces." : "";
      throw tokens.unitProblem(token, "There is no unit '" + text + "'.", hint + blanks);
    }
    return unit.get();
  }

  private Term absolute() {
    tokens.require("(", "Write, for example, `abs(ego.acceleration)`.");
    Term inner = argument();
    tokens.require(")", "`abs` takes one argument.");
    return inner.absolute();
  }

  private Term ceiling() {
    tokens.require("(", "Write, for example, `ceil(gap / 1 m)`.");
    Token place = tokens.peek();
    Term inner = argument();
    tokens.require(")", "`ceil` takes one argument.");
    if (!inner.isWithoutUnit()) {
      throw tokens.unitProblem(
          place,
          "`ceil` takes a number without a unit, not one in " + named(inner) + ".",
          "Divide by the unit: `ceil(gap / 1 m)`.");
    }
    return inner.ceiling();
  }

  /** Parses what follows {@code if}. */
  private Term conditional(Token start) {
    Token first = tokens.peek();
    Condition condition = conditions.apply(parenthesized.get(), first);
    if (!condition.ofOneMoment()) {
      throw tokens.syntax(
          first, "`if` needs what holds at one moment.", "Leave out operators such as `always`.");
    }
    tokens.require("then", "Write, for example, `if gap < 15 m then 20 m/s else 30 m/s`.");
    Term one = summed();
    tokens.require("else", "`if` has a value in either case.");
    Token second = tokens.peek();
    Term other = summed();
    requireSameDimension(one, other, second);
    Term either = one.where(condition, other);
    requireNoTruth(either, one, other, start);
    return either;
  }

  private void requireNoTruth(Term either, Term one, Term other, Token start) {
    if (one.truth() || other.truth()) {
      throw tokens.syntax(
          start,
          "`if` is for quantities in " + named(either) + ", not for what is true or false.",
          "Write `(p implies q) and (not p implies r)`.");
    }
  }

  private Term summed() {
    Token first = tokens.peek();
    return term(sum(), first);
  }

  private Term derivative(Token start) {
    tokens.require("(", "Write, for example, `derivative(ego.acceleration, 0.1 s)`.");
    Term inner = argument();
    tokens.require(",", "The second argument is the time over which it is taken, such as 0.1 s.");
    Token place = tokens.peek();
    Term window = argument();
    tokens.require(")", "`derivative` takes two arguments.");
    if (longest == 0.0) {
      throw tokens.syntax(start, "Here only one moment is known, and no change.", "");
    }
    if (!window.comparesWith(SECOND) || !window.sum().isNumber()) {
      throw tokens.unitProblem(place, "The second argument is not a number of seconds.", "");
    }
    double seconds = window.sum().number();
    if (seconds < STEP - 1e-9 || seconds > longest) {
      throw tokens.syntax(
          place,
          String.format(
              Locale.ROOT, "It is from %s s to the %s s that the scenario lasts.", STEP, longest),
          "");
    }
    return inner.derivative((int) Math.round(seconds / STEP));
  }

  private Term extreme(boolean larger) {
    tokens.require("(", "Write, for example, `min(gap, 10 m)`.");
    Term all = argument();
    tokens.require(",", "`min` and `max` take two or more arguments.");
    do {
      Token second = tokens.peek();
      Term other = argument();
      requireSameDimension(all, other, second);
      all = all.extreme(other, larger);
    } while (tokens.take(","));
    tokens.require(")", "");
    return all;
  }

  private Term argument() {
    Token first = tokens.peek();
    return term(parenthesized.get(), first);
  }

  /** Returns a signal, or its comparison with the name of a value. */
  private Part signal(Token token) {
    Signal signal = find(token);
    Optional<Condition> named = names.comparison(signal, token);
    return named.isPresent() ? named.get() : Term.of(signal);
  }

  private Signal find(Token token) {
    if (Operator.KEYWORDS.contains(token.text())) {
      String message = "Expected a quantity, but found '" + token.text() + "'.";
      throw tokens.syntax(token, message, "Put what follows into parentheses.");
    }
    Matcher output = FormulaTokens.OUTPUT.matcher(token.text());
    if (output.matches() && !signals.readsOutputs()) {
      throw tokens.unknownSignal(token, "Outputs of the software cannot be read here.", "");
    }
    if (output.matches()) {
      return output(output.group("id"), Optional.ofNullable(output.group("kind")), token);
    }
    String name = ActorSignals.named(token.text());
    Optional<Signal> signal = signals.find(name);
    if (signal.isEmpty()) {
      throw unknown(name, token);
    }
    return signal.get();
  }

  private DiagnosticException unknown(String name, Token token) {
    if (FormulaTokens.ACTOR.matcher(name).matches()) {
      boolean known = signals.names().stream().anyMatch(ActorSignals::isOne);
      String hint = known ? NearestName.hint(name, signals.names()) : ActorSignals.NONE_KNOWN;
      return tokens.unknownSignal(token, "There is no " + name + " here.", hint);
    }
    String described = name.startsWith("/") ? signals.aboutTopics() : "";
    String hint = NearestName.hint(name, signals.names()) + described;
    return tokens.unknownSignal(token, "There is no signal '" + name + "'.", hint);
  }

  /** Returns the only output that satisfies a requirement. */
  private Signal output(String requirement, Optional<String> kind, Token token) {
    kind.filter(it -> !it.equals("bool")).ifPresent(it -> unit(it, token));
    Optional<List<Signal>> known = signals.outputs(requirement, kind);
    if (known.isEmpty()) {
      return unresolved("there is no chain yet", kind, token);
    }
    List<Signal> found = known.get();
    String wanted = kind.map(it -> it.equals("bool") ? " of type bool" : " in " + it).orElse("");
    if (found.isEmpty()) {
      return unresolved(
          "no output%s of the chain satisfies %s%s"
              .formatted(wanted, requirement, others(requirement)),
          kind,
          token);
    }
    if (found.size() > 1) {
      String names = found.stream().map(Signal::name).collect(Collectors.joining(", "));
      return unresolved(
          "several outputs%s of the chain satisfy %s: %s".formatted(wanted, requirement, names),
          kind,
          token);
    }
    return found.get(0);
  }

  /** Returns the outputs of other types and units that satisfy a requirement, in words. */
  private String others(String requirement) {
    String names =
        signals.outputs(requirement, Optional.empty()).orElse(List.of()).stream()
            .map(each -> each.name() + (each.truth() ? " (bool)" : " (a number" + in(each) + ")"))
            .collect(Collectors.joining(", "));
    return names.isEmpty() ? "" : ", only " + names;
  }

  private static String in(Signal output) {
    return output.unit().isEmpty() || output.unit().equals("1") ? "" : " in " + output.unit();
  }

  /**
   * Returns a signal without values in place of an output, so that the rest of the formula is
   * checked.
   */
  private Signal unresolved(String reason, Optional<String> kind, Token token) {
    UnresolvedOutputException problem = new UnresolvedOutputException(reason);
    if (kind.isEmpty()) {
      throw problem; // Whether the rest fits is not known.
    }
    unresolved = unresolved.or(() -> Optional.of(problem));
    boolean truth = kind.get().equals("bool");
    return new Signal(
        token.text(),
        truth ? "1" : kind.get(),
        truth,
        reason,
        trace -> new double[trace.states().size()],
        trace -> Optional.of(reason));
  }

  /** Ends the parsing of a formula that reads an output which is not known. */
  void requireResolved() {
    if (unresolved.isPresent()) {
      throw unresolved.get();
    }
  }

  private Term term(Part part, Token first) {
    if (part instanceof Term term) {
      return term;
    }
    String text = tokens.textSince(first);
    throw tokens.syntax(first, "'" + text + "' is true or false, not a quantity.", "");
  }

  /** Rejects terms of different dimensions, such as metres and seconds. */
  void requireSameDimension(Term before, Term after, Token second) {
    if (!before.comparesWith(after)) {
      String message =
          "'" + tokens.textSince(second) + "' is in " + named(after) + ", what is before it in ";
      boolean plain = isPlainNumber(after) || isPlainNumber(before);
      String hint = plain ? "Each number needs its unit: `0 m`, and not `0`." : "";
      throw tokens.unitProblem(second, message + named(before) + ".", hint);
    }
  }

  private static boolean isPlainNumber(Term term) {
    return term.signals().isEmpty() && named(term).equals("1");
  }

  private static String named(Term term) {
    return term.unit().isEmpty() ? "another unit" : term.unit();
  }
}

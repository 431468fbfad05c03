package dev.eventchain.simulation.formula;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.formula.FormulaTokens.Kind;
import dev.eventchain.simulation.formula.FormulaTokens.Token;
import java.util.Map;
import java.util.Optional;

/** Parses comparisons of signals with names of their values: {@code /gear.data == 'REVERSE'}. */
final class NamedValueParser {

  /** Signs for the same relation. */
  private static final Map<String, String> SIGNS =
      Map.of("==", "==", "=", "==", "!=", "!=", "<>", "!=");

  private final FormulaTokens tokens;

  NamedValueParser(FormulaTokens tokens) {
    this.tokens = tokens;
  }

  /**
   * Parses what follows a signal, if it is a comparison with a name.
   *
   * @param first the token of the signal
   */
  Optional<Condition> comparison(Signal signal, Token first) {
    Token relation = tokens.peek();
    boolean isEquality = relation.kind() == Kind.SIGN && SIGNS.containsKey(relation.text());
    if (!isEquality || tokens.second().kind() != Kind.TEXT) {
      requireNoName(signal, first, isEquality ? relation : first, isEquality);
      return Optional.empty();
    }
    tokens.next();
    Token text = tokens.next();
    String sign = SIGNS.get(relation.text());
    if (!relation.text().equals(sign)) {
      throw tokens.syntax(
          relation,
          "Names are not compared by '" + relation.text() + "'.",
          "Write `" + sign + "`.");
    }
    String name = text.text().substring(1, text.text().length() - 1);
    if (signal.named().isEmpty()) {
      throw tokens.unknownSignal(
          text, "No value of '" + signal.name() + "' has a name.", signal.truth() ? TRUTH : NUMBER);
    }
    if (!signal.named().names().contains(name)) {
      throw tokens.unknownSignal(
          text,
          "'" + signal.name() + "' is never '" + name + "'.",
          NearestName.hint(name, signal.named().names()));
    }
    return Optional.of(condition(new NamedPart(signal, name), sign, tokens.textSince(first)));
  }

  private static final String TRUTH = "It is true or false: write it alone, or `not` before it.";
  private static final String NUMBER =
      "Names come from a catalogue or from constants of its message. Compare it with a number.";

  private void requireNoName(Signal signal, Token first, Token place, boolean isEquality) {
    if (!signal.named().isText() && (!isEquality || signal.named().isEmpty())) {
      return;
    }
    String name = signal.named().names().get(0);
    throw tokens.syntax(
        place,
        signal.named().isText()
            ? "'" + signal.name() + "' is a text, and only compared with names of its values."
            : "'" + signal.name() + "' is only equal to names of its values.",
        "Write, for example, `" + first.text() + " == '" + name + "'`.");
  }

  private static Condition condition(NamedPart part, String sign, String text) {
    Term is = part.term();
    Unit one = is.dimension();
    return sign.equals("==")
        ? Condition.Comparison.isTrue(is, text)
        : new Condition.Comparison(is, Term.number(0.5, one, "1"), true, text);
  }
}

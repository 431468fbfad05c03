package dev.eventchain.simulation.formula;

import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.formula.FormulaTokens.Kind;
import dev.eventchain.simulation.formula.FormulaTokens.Token;
import dev.eventchain.simulation.world.World;
import java.util.IdentityHashMap;
import java.util.Locale;

/** Parses the intervals of a formula, and checks that a scenario can reach them. */
final class IntervalParser {

  private static final Unit SECOND = Unit.parse("s").orElseThrow();

  private final FormulaTokens tokens;
  private final double duration;
  private final IdentityHashMap<Interval, Token> places = new IdentityHashMap<>();

  IntervalParser(FormulaTokens tokens, double duration) {
    this.tokens = tokens;
    this.duration = duration;
  }

  /** Parses an interval; returns the whole run if there is none. */
  Interval parse() {
    Token opening = tokens.peek();
    if (!tokens.take("[")) {
      return Interval.ALL;
    }
    String hint = "Write, for example, `[0, 0.25]`, in seconds.";
    int from = bound(hint);
    tokens.require(",", hint);
    int to = bound(hint);
    tokens.require("]", hint);
    if (to < from) {
      throw tokens.syntax(opening, "The interval ends before it begins.", "Swap its bounds.");
    }
    Interval interval = new Interval(from, to, true);
    places.put(interval, opening);
    return interval;
  }

  /** Parses a bound, in samples. */
  private int bound(String hint) {
    Token sign = tokens.peek();
    boolean negative = tokens.take("-");
    Token number = tokens.next();
    if (number.kind() != Kind.NUMBER) {
      String found = FormulaTokens.shown(number);
      throw tokens.syntax(number, "Expected a number of seconds, but found " + found + ".", hint);
    }
    double seconds = unit().coherent(Double.parseDouble(number.text()));
    if (negative) {
      throw tokens.syntax(sign, "The interval reaches into the past.", "Begin at 0 or later.");
    }
    if (seconds > duration) {
      throw tokens.syntax(number, "The interval ends after the scenario.", lasts());
    }
    long nanoseconds = World.nanoseconds(seconds);
    if (nanoseconds % World.TRACE_STEP != 0) {
      throw tokens.syntax(
          number, "The interval ends between two samples.", "Use multiples of 10 ms.");
    }
    return (int) (nanoseconds / World.TRACE_STEP);
  }

  private Unit unit() {
    Token unit = tokens.peek();
    if (unit.kind() != Kind.UNIT) {
      return SECOND;
    }
    tokens.next();
    return Unit.parse(unit.text())
        .filter(
            it ->
                it.relationTo(SECOND) == Unit.Relation.SAME
                    || it.relationTo(SECOND) == Unit.Relation.CONVERTIBLE)
        .orElseThrow(
            () ->
                tokens.unitProblem(
                    unit,
                    "'" + unit.text() + "' is not a unit of time.",
                    "Write s or ms; a number without a unit is in seconds."));
  }

  private String lasts() {
    return String.format(Locale.ROOT, "The scenario lasts at most %s s.", duration);
  }

  /** Rejects nested intervals that together reach beyond the end of the scenario. */
  void requireReached(Condition condition) {
    requireReached(condition, 0);
  }

  /** Rejects a formula that is judged at a single sample, though it says that it always holds. */
  void requireLong(Condition condition) {
    if (condition instanceof Condition.Temporal temporal
        && temporal.interval().bounded()
        && temporal.interval().to() == temporal.interval().from()) {
      throw tokens.syntax(
          places.get(temporal.interval()),
          "The interval is a single moment.",
          "Begin it when the condition must hold, and end it as late as it must hold.");
    }
    if (condition instanceof Condition.Junction || condition instanceof Condition.Negation) {
      condition.parts().forEach(this::requireLong);
    }
  }

  private void requireReached(Condition condition, long start) {
    for (int i = 0; i < condition.parts().size(); i++) {
      Interval interval = condition.window(i);
      long end = interval.bounded() ? start + interval.to() : start;
      if (end * World.TRACE_STEP > World.nanoseconds(duration) && places.containsKey(interval)) {
        throw tokens.syntax(
            places.get(interval),
            String.format(
                Locale.ROOT,
                "With the intervals around it, it reaches %s s after the start.",
                World.seconds(end * World.TRACE_STEP)),
            lasts());
      }
      requireReached(condition.parts().get(i), end);
    }
  }
}

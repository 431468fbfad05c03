package dev.eventchain.simulation.formula;

import java.util.Arrays;
import java.util.Locale;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Operators and functions of formulas, and what users read about them. */
public enum Operator {
  COMPARISON(
      "x < y, x <= y, x > y, x >= y, x == 'NAME', x != 'NAME'",
      "the comparison holds. Quantities are never equal: give a tolerance. A NAME is that of a value",
      "always abs(ego.offset) <= 0.5 m"),
  ALWAYS(
      "always[a,b] p",
      "p is true at all samples from a to b after this one; without an interval, up to the end",
      "always[0,1] ego.speed >= 0 m/s"),
  EVENTUALLY(
      "eventually[a,b] p",
      "p is true at a sample from a to b after this one; without an interval, up to the end",
      "eventually[0,1] brake > 0.5"),
  UNTIL(
      "p until[a,b] q",
      "q is true at a sample from a to b after this one, and p at each sample before that one",
      "brake < 0.5 until[0,1] gap < 15 m"),
  HISTORICALLY(
      "historically[a,b] p",
      "p was true at all samples from b to a before this one; without an interval, from the start",
      "always (rise(brake > 0.5) implies historically[0.01,0.3] throttle > 0.1)"),
  ONCE(
      "once[a,b] p",
      "p was true at a sample from b to a before this one; without an interval, since the start",
      "always (brake > 0.5 implies once[0,0.2] gap > 14 m)"),
  SINCE(
      "p since[a,b] q",
      "q was true at a sample from b to a before this one, and p at each sample after that one",
      "always (ego.speed >= 5 m/s implies (ego.speed >= 3 m/s since[0,1] ego.speed < 4 m/s))"),
  RISE(
      "rise(p)",
      "p has become true since the sample before; never at the first one",
      "eventually[0,1] rise(brake > 0.5)"),
  FALL(
      "fall(p)",
      "p has become false since the sample before; never at the first one",
      "eventually[0,1] fall(brake > 0.5)"),
  NOT("not p", "p is false", "always not gap < 1 m"),
  AND("p and q", "both are true", "always (gap > 1 m and ego.speed >= 0 m/s)"),
  OR("p or q", "at least one is true", "always (brake < 0.5 or gap < 15 m)"),
  IMPLIES(
      "p implies q",
      "q is true, or p is not. Where p never comes true, nothing was tested",
      "always (brake > 0.5 implies gap < 15 m)"),
  ARITHMETIC(
      "x + y, x - y, x * y, x / y, -x", "as usual, with units", "always gap / 2 + 1 m > 0.5 m"),
  IF(
      "if p then x else y",
      "x where p is true, y where it is false, no value where that is unknown",
      "always ego.speed <= (if gap < 15 m then 20 m/s else 30 m/s)"),
  DERIVATIVE(
      "derivative(x, 0.1 s)",
      "the change of x over that time before each sample, per second",
      "always derivative(ego.speed, 0.1 s) < 50 m/s2"),
  ABS("abs(x)", "the size without the sign", "always abs(ego.acceleration) < 20 m/s2"),
  CEIL(
      "ceil(x)",
      "the next whole number that is not smaller than a number without a unit",
      "always ceil(gap / 1 m) > 0.5"),
  MIN("min(x, y, ...)", "the smallest", "always min(gap, 15 m) <= 15.5 m"),
  MAX("max(x, y, ...)", "the largest", "always max(gap, 5 m) >= 4.5 m");

  private static final Set<Operator> WITH_SIGNS = Set.of(COMPARISON, ARITHMETIC);

  /** Reserved words, which no unit and no signal may use. */
  static final Set<String> KEYWORDS =
      Stream.concat(
              Arrays.stream(values())
                  .filter(Predicate.not(WITH_SIGNS::contains))
                  .map(Operator::word),
              Stream.of("then", "else"))
          .collect(Collectors.toUnmodifiableSet());

  private final String written;
  private final String meaning;
  private final String example;

  Operator(String written, String meaning, String example) {
    this.written = written;
    this.meaning = meaning;
    this.example = example;
  }

  /** Returns the reserved word. */
  private String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns how it is written. */
  public String written() {
    return written;
  }

  /** Returns when it is true, or what its value is. */
  public String meaning() {
    return meaning;
  }

  /** Returns a formula with it. */
  public String example() {
    return example;
  }
}

package dev.eventchain.simulation.formula;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.world.States;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.function.IntFunction;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests random formulas on random runs against the definitions of their operators, evaluated sample
 * by sample. Values are small integers, so that many are equal.
 */
class FormulaReferenceTest {

  private static final int FORMULAS = 1500;

  /** True (1), false (-1) or unknown (0), with a signed margin, in ascending order. */
  private record Value(int verdict, double margin) implements Comparable<Value> {
    static final Value UNKNOWN = new Value(0, 0);
    static final Value NEVER = new Value(-1, Double.NEGATIVE_INFINITY);

    static Value of(boolean verdict, double margin) {
      return new Value(verdict ? 1 : -1, margin);
    }

    Value not() {
      return new Value(-verdict, 0.0 - margin);
    }

    Value and(Value other) {
      return compareTo(other) <= 0 ? this : other;
    }

    Value or(Value other) {
      return compareTo(other) >= 0 ? this : other;
    }

    @Override
    public int compareTo(Value other) {
      int order = Integer.compare(verdict, other.verdict);
      return order != 0 ? order : Double.compare(margin, other.margin);
    }
  }

  /** A formula, and its value at a sample by definition: unknown after the end. */
  private record Case(String text, IntFunction<Value> definition) {
    Value at(int sample, int size) {
      return sample < size ? definition.apply(sample) : Value.UNKNOWN;
    }
  }

  private final Map<String, Case> comparisons = new HashMap<>();
  private Random random;
  private boolean oneUnit;
  private int size;
  private double[] speeds;
  private double[] gaps;

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void verdictsAndMarginsAreThoseOfTheDefinitions(boolean withOneUnit) {
    random = new Random(20_240_607);
    oneUnit = withOneUnit;
    Set<Integer> verdicts = new HashSet<>();
    for (int i = 0; i < FORMULAS; i++) {
      comparisons.clear();
      Trace trace = trace();
      Case formula = formula(3);
      Value expected = formula.at(0, size);
      FormulaEvaluation found =
          FormulaEvaluation.of(
              Formula.parse(SourceText.of("f", formula.text()).whole(), new WorldSignals(), 600)
                  .condition(),
              new SampledRun(trace));
      String about = formula.text() + " of " + size;
      assertEquals(expected.verdict(), (int) Math.signum(found.verdict()), about);
      if (oneUnit) {
        assertEquals(Math.abs(expected.margin()), Robustness.margin(found.verdict()), about);
      }
      requireDecision(found, expected, about);
      verdicts.add(expected.verdict());
    }
    assertEquals(Set.of(-1, 0, 1), verdicts);
  }

  /** Requires that the deciding comparison has the margin of the formula, or else its own. */
  private void requireDecision(FormulaEvaluation found, Value expected, String about) {
    FormulaEvaluation.Decision decision = found.decision();
    if (decision.comparison().isPresent()) {
      Case comparison = comparisons.get(decision.comparison().get().text());
      Value there = comparison.at(decision.sample(), size);
      assertEquals(Math.abs(there.margin()), Robustness.margin(decision.truth()), about);
      assertEquals(there.verdict(), (int) Math.signum(decision.truth()), about);
      if (oneUnit) {
        assertEquals(Math.abs(expected.margin()), Math.abs(there.margin()), about);
      }
    } else {
      boolean edge = !oneUnit || Double.isInfinite(expected.margin());
      assertTrue(expected.verdict() == 0 || edge, about);
    }
  }

  private Trace trace() {
    Trace trace = new Trace();
    size = 1 + random.nextInt(12);
    speeds = new double[size];
    gaps = new double[size];
    for (int i = 0; i < size; i++) {
      speeds[i] = random.nextInt(5);
      gaps[i] = random.nextInt(6) == 0 ? Double.POSITIVE_INFINITY : random.nextInt(5);
      trace.state(States.of(i * World.TRACE_STEP, speeds[i], gaps[i], 1, 0));
    }
    return trace;
  }

  private Case formula(int depth) {
    if (depth == 0) {
      return comparison();
    }
    Case first = formula(depth - 1);
    return switch (random.nextInt(11)) {
      case 0 -> new Case("(not " + first.text() + ")", i -> first.at(i, size).not());
      case 1 -> edge(first);
      case 2 -> temporal(first, true);
      case 3 -> temporal(first, false);
      case 4 -> until(first, formula(depth - 1));
      case 5 -> past(first, true);
      case 6 -> past(first, false);
      case 7 -> since(first, formula(depth - 1));
      default -> junction(first, formula(random.nextInt(depth)));
    };
  }

  private Case comparison() {
    boolean speed = oneUnit || random.nextBoolean();
    double[] values = speed ? speeds : gaps;
    int limit = random.nextInt(5);
    boolean less = random.nextBoolean();
    boolean strict = random.nextBoolean();
    String text =
        (speed ? "ego.speed" : "gap") + (less ? " <" : " >") + (strict ? " " : "= ") + limit;
    Case made =
        new Case(
            text + (speed ? " m/s" : " m"),
            i -> {
              double margin = less ? limit - values[i] : values[i] - limit;
              return Value.of(strict ? margin > 0 : margin >= 0, margin);
            });
    comparisons.put(made.text(), made);
    return new Case("(" + made.text() + ")", made.definition());
  }

  private Case junction(Case first, Case second) {
    return switch (random.nextInt(3)) {
      case 0 ->
          new Case(
              "(" + first.text() + " and " + second.text() + ")",
              i -> first.at(i, size).and(second.at(i, size)));
      case 1 ->
          new Case(
              "(" + first.text() + " or " + second.text() + ")",
              i -> first.at(i, size).or(second.at(i, size)));
      default ->
          new Case(
              "(" + first.text() + " implies " + second.text() + ")",
              i -> first.at(i, size).not().or(second.at(i, size)));
    };
  }

  private Case edge(Case operand) {
    boolean rises = random.nextBoolean();
    return new Case(
        (rises ? "rise(" : "fall(") + operand.text() + ")",
        i -> {
          if (i == 0) {
            return Value.NEVER;
          }
          Value now = operand.at(i, size);
          Value before = operand.at(i - 1, size);
          return rises ? now.and(before.not()) : now.not().and(before);
        });
  }

  private Case temporal(Case operand, boolean always) {
    boolean bounded = random.nextInt(4) > 0;
    int from = bounded ? random.nextInt(5) : 0;
    int length = bounded ? random.nextInt(7) : size;
    return new Case(
        "("
            + (always ? "always" : "eventually")
            + interval(bounded, from, length)
            + operand.text()
            + ")",
        i -> {
          Value value = null;
          for (int j = i + from; j <= i + from + length && (bounded || j < size); j++) {
            Value there = operand.at(j, size);
            value = value == null ? there : always ? value.and(there) : value.or(there);
          }
          return value;
        });
  }

  private Case until(Case kept, Case reached) {
    boolean bounded = random.nextInt(4) > 0;
    int from = bounded ? random.nextInt(5) : 0;
    int length = bounded ? random.nextInt(7) : size;
    return new Case(
        "(" + kept.text() + " until" + interval(bounded, from, length) + reached.text() + ")",
        i -> {
          Value value = Value.NEVER;
          for (int j = i + from; j <= i + from + length && (bounded || j < size); j++) {
            Value there = reached.at(j, size);
            for (int k = i; k < j; k++) {
              there = there.and(kept.at(k, size));
            }
            value = value.or(there);
          }
          return value;
        });
  }

  private Case past(Case operand, boolean always) {
    boolean bounded = random.nextInt(4) > 0;
    int from = bounded ? random.nextInt(5) : 0;
    int length = bounded ? random.nextInt(7) : size;
    return new Case(
        "("
            + (always ? "historically" : "once")
            + interval(bounded, from, length)
            + operand.text()
            + ")",
        i -> {
          Value value = Value.UNKNOWN;
          for (int j = i - from; j >= Math.max(0, i - from - length); j--) {
            Value there = operand.at(j, size);
            value = j == i - from ? there : always ? value.and(there) : value.or(there);
          }
          return value;
        });
  }

  private Case since(Case kept, Case reached) {
    boolean bounded = random.nextInt(4) > 0;
    int from = bounded ? random.nextInt(5) : 0;
    int length = bounded ? random.nextInt(7) : size;
    return new Case(
        "(" + kept.text() + " since" + interval(bounded, from, length) + reached.text() + ")",
        i -> {
          Value value = i < from ? Value.UNKNOWN : Value.NEVER;
          for (int j = i - from; j >= Math.max(0, i - from - length); j--) {
            Value there = reached.at(j, size);
            for (int k = j + 1; k <= i; k++) {
              there = there.and(kept.at(k, size));
            }
            value = value.or(there);
          }
          return value;
        });
  }

  private static String interval(boolean bounded, int from, int length) {
    return bounded
        ? String.format(Locale.ROOT, "[%.2f,%.2f] ", from / 100.0, (from + length) / 100.0)
        : " ";
  }
}

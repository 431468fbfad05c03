package dev.eventchain.pipeline.search;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.pipeline.search.IndependentSearch.Answer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests searches on functions with known minima. */
class IndependentSearchTest {

  /** Functions on the unit cube whose smallest value is 0. */
  private enum Known {
    SPHERE {
      @Override
      double at(double[] x) {
        return Arrays.stream(x).map(each -> (each - 0.3) * (each - 0.3)).sum();
      }
    },
    /** On -2 to 2, with the minimum at 1. */
    ROSENBROCK {
      @Override
      double at(double[] x) {
        double sum = 0;
        for (int i = 0; i + 1 < x.length; i++) {
          double a = 4 * x[i] - 2;
          double b = 4 * x[i + 1] - 2;
          sum += 100 * (b - a * a) * (b - a * a) + (1 - a) * (1 - a);
        }
        return sum;
      }
    },
    /** Ten thousand times as steep across as along, and not along an axis. */
    VALLEY {
      @Override
      double at(double[] x) {
        double across = x[0] - x[1];
        double along = (x[0] + x[1]) / 2 - 0.7;
        return 100 * across * across + 0.01 * along * along;
      }
    },
    CORNER {
      @Override
      double at(double[] x) {
        return Arrays.stream(x).sum();
      }
    },
    FAR_CORNER {
      @Override
      double at(double[] x) {
        return Arrays.stream(x).map(each -> 1 - each).sum();
      }
    };

    abstract double at(double[] x);
  }

  /** Keeps all that was asked. */
  private static final class Asked implements IndependentSearch.Function {

    private final ToDoubleFunction<double[]> function;
    private final double findsBelow;
    private final List<double[]> points = new ArrayList<>();
    private double best = Double.POSITIVE_INFINITY;

    Asked(ToDoubleFunction<double[]> function, double findsBelow) {
      this.function = function;
      this.findsBelow = findsBelow;
    }

    @Override
    public boolean isOpen() {
      return true;
    }

    @Override
    public Answer at(double[] point) {
      assertTrue(Arrays.stream(point).allMatch(it -> it >= 0 && it < 1), Arrays.toString(point));
      points.add(point);
      double value = function.applyAsDouble(point);
      best = Math.min(best, value);
      return new Answer(value, true, value < findsBelow);
    }
  }

  private static Asked search(
      SearchMethod method, Asked asked, int dimensions, int evaluations, long seed) {
    double[] middle = new double[dimensions];
    Arrays.fill(middle, 0.5);
    new IndependentSearch(method, asked, evaluations, seed).run(middle);
    assertEquals(evaluations, asked.points.size());
    return asked;
  }

  @ParameterizedTest
  @CsvSource({
    "SPHERE, 1, 100, 1e-6",
    "SPHERE, 4, 400, 1e-4",
    "ROSENBROCK, 2, 500, 1e-3",
    "VALLEY, 2, 500, 1e-4",
    "CORNER, 4, 300, 1e-3",
    "FAR_CORNER, 4, 300, 1e-3"
  })
  void evolutionComesToTheKnownMinimum(Known known, int dimensions, int evaluations, double least) {
    for (long seed = 1; seed <= 5; seed++) {
      Asked asked = new Asked(known::at, -1);
      double best = search(SearchMethod.CMA_ES, asked, dimensions, evaluations, seed).best;
      assertTrue(best < least, known + " with seed " + seed + ": " + best);
    }
  }

  @Test
  void randomDrawsComeLessNear() {
    Asked drawn = search(SearchMethod.RANDOM, new Asked(Known.SPHERE::at, -1), 4, 300, 1);
    assertTrue(drawn.best > 1e-5 && drawn.best < 0.1, () -> "" + drawn.best);
  }

  /** Without any difference, all there is to do is to look around. */
  @ParameterizedTest
  @EnumSource(SearchMethod.class)
  void aFlatFunctionIsSearchedToTheEnd(SearchMethod method) {
    Asked asked = search(method, new Asked(x -> 1, -1), 2, 200, 3);
    double[] first = asked.points.stream().mapToDouble(it -> it[0]).sorted().toArray();
    assertTrue(first[first.length - 1] - first[0] > 0.5);
  }

  @ParameterizedTest
  @EnumSource(SearchMethod.class)
  void theSameSeedAsksTheSame(SearchMethod method) {
    Asked one = search(method, new Asked(Known.VALLEY::at, -1), 2, 60, 7);
    Asked same = search(method, new Asked(Known.VALLEY::at, -1), 2, 60, 7);
    Asked other = search(method, new Asked(Known.VALLEY::at, -1), 2, 60, 8);
    for (int i = 0; i < 60; i++) {
      assertArrayEquals(one.points.get(i), same.points.get(i));
    }
    assertTrue(!Arrays.equals(one.points.get(59), other.points.get(59)));
  }

  /** Two pits, of which the deeper one holds whoever is in it, unless it goes on elsewhere. */
  @Test
  void afterAFindItBeginsElsewhere() {
    ToDoubleFunction<double[]> pits =
        x -> Math.min(Math.abs(x[0] - 0.2) - 0.05, Math.abs(x[0] - 0.8) - 0.04);
    Asked asked = search(SearchMethod.CMA_ES, new Asked(pits, 0), 1, 100, 1);
    Set<Boolean> sides = new HashSet<>();
    asked.points.stream()
        .filter(it -> pits.applyAsDouble(it) < 0)
        .forEach(it -> sides.add(it[0] < 0.5));
    assertEquals(Set.of(true, false), sides);
  }

  /** Answers that were known take no evaluation, and do not go on for ever. */
  @Test
  void aSpaceOfOneValueEnds() {
    int[] questions = {0};
    IndependentSearch.Function known =
        new IndependentSearch.Function() {
          @Override
          public boolean isOpen() {
            return true;
          }

          @Override
          public Answer at(double[] point) {
            questions[0]++;
            return new Answer(1, false, false);
          }
        };
    for (SearchMethod method : SearchMethod.values()) {
      questions[0] = 0;
      new IndependentSearch(method, known, 10, 1).run(new double[] {0.5});
      assertEquals(200, questions[0]);
    }
  }
}

package dev.eventchain.pipeline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests values that are drawn from distributions. */
class LevelsTest {

  private static final int DRAWS = 20_000;

  private static Levels.Normal normal(double mean, double deviation, double least, double most) {
    return new Levels.Normal(
        BigDecimal.valueOf(mean),
        BigDecimal.valueOf(deviation),
        BigDecimal.valueOf(least),
        BigDecimal.valueOf(most));
  }

  /** Draws a value from each of equal shares. */
  private static double[] values(Levels levels) {
    return IntStream.range(0, DRAWS)
        .mapToDouble(k -> levels.at((k + 0.5) / DRAWS).doubleValue())
        .toArray();
  }

  private static double mean(DoubleStream values) {
    return values.average().orElseThrow();
  }

  @Test
  void aNormalDistributionHasItsMeanAndDeviation() {
    double[] values = values(normal(50, 4, 26, 74));
    assertEquals(50, mean(DoubleStream.of(values)), 0.001);
    double variance = mean(DoubleStream.of(values).map(x -> (x - 50) * (x - 50)));
    assertEquals(16, variance, 0.02);
    double near = DoubleStream.of(values).filter(x -> Math.abs(x - 50) < 4).count();
    assertEquals(0.682689, near / DRAWS, 0.0002);
  }

  /** The mean of a half-normal distribution is the square root of 2/pi. */
  @Test
  void valuesBeyondABoundAreNotThere() {
    double[] values = values(normal(0, 1, 0, 9));
    assertTrue(DoubleStream.of(values).allMatch(x -> x >= 0));
    assertEquals(Math.sqrt(2 / Math.PI), mean(DoubleStream.of(values)), 0.001);
  }

  /** In a far tail, the mean is known: that of the density over the mass of the tail. */
  @Test
  void aTailIsDrawnOnBothSidesAlike() {
    double[] above = values(normal(0, 1, 5, 12));
    double[] below = values(normal(0, 1, -12, -5));
    assertEquals(5.186504, mean(DoubleStream.of(above)), 0.001);
    for (int k = 0; k < DRAWS; k++) {
      assertTrue(above[k] >= 5 && above[k] <= 12, () -> "outside of its bounds");
      assertEquals(above[k], -below[DRAWS - 1 - k], 1e-6);
    }
  }

  @Test
  void theEndsAreTheBounds() {
    Levels.Normal levels = normal(10, 2, 9, 12);
    assertEquals(9, levels.at(0.0).doubleValue(), 1e-6);
    assertEquals(12, levels.at(Math.nextDown(1.0)).doubleValue(), 1e-6);
    assertEquals("[9.0, 12.0]", levels.checked().toString());
  }
}

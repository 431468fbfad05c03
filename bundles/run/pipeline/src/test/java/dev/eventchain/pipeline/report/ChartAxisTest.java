package dev.eventchain.pipeline.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Tests that axes are divided by round numbers. */
class ChartAxisTest {

  private static String ticks(double least, double most, int steps) {
    return ChartAxis.of(least, most, steps).ticks().stream()
        .map(ChartAxis::text)
        .collect(Collectors.joining(" "));
  }

  @Test
  void theNumbersAreRound() {
    assertEquals("0 20 40 60 80 100", ticks(3, 97, 6));
    assertEquals("-1 -0.5 0 0.5", ticks(-0.6, 0.4, 3));
    assertEquals("0.0002 0.0004 0.0006", ticks(0.00025, 0.0006, 2));
    assertEquals("5 10", ticks(7, 7, 2));
    assertEquals("0 0.5", ticks(0, 0, 2));
  }

  @Test
  void aValueOnANumberBelongsToTheStepAfterIt() {
    ChartAxis axis = ChartAxis.of(-0.3, 0.3, 6);
    assertEquals("-0.3 -0.2 -0.1 0 0.1 0.2 0.3", ticks(-0.3, 0.3, 6));
    assertEquals(3, axis.bin(0));
    assertEquals(0, axis.bin(-0.3));
    assertEquals(5, axis.bin(0.3));
  }

  @Property
  void allValuesLieBetweenThem(
      @ForAll @DoubleRange(min = -1e6, max = 1e6) double one,
      @ForAll @DoubleRange(min = -1e6, max = 1e6) double other) {
    double least = Math.min(one, other);
    double most = Math.max(one, other);
    ChartAxis axis = ChartAxis.of(least, most, 16);
    List<BigDecimal> ticks = axis.ticks();
    assertTrue(ticks.get(0).doubleValue() <= least + 1e-9 * Math.abs(least));
    assertTrue(ticks.get(axis.count()).doubleValue() >= most - 1e-9 * Math.abs(most));
    assertTrue(axis.count() <= 18, axis::toString);
    for (double value : new double[] {least, (least + most) / 2, most}) {
      assertTrue(axis.bin(value) >= 0 && axis.bin(value) < axis.count());
    }
    if (least < 0 && most > 0) {
      assertTrue(ticks.stream().anyMatch(tick -> tick.signum() == 0), axis::toString);
    }
  }
}

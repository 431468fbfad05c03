package dev.eventchain.pipeline.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the confidence interval of a rate. */
class WilsonIntervalTest {

  /** R. G. Newcombe, Two-sided confidence intervals for the single proportion (1998), table I. */
  @ParameterizedTest
  @CsvSource({
    "81, 263, 0.2553, 0.3662",
    "15, 148, 0.0624, 0.1605",
    "0, 20, 0, 0.1611",
    "1, 29, 0.0061, 0.1718"
  })
  void publishedValues(int successes, int trials, double low, double high) {
    WilsonInterval interval = WilsonInterval.of(successes, trials).orElseThrow();
    assertEquals(low, interval.low(), 5e-5);
    assertEquals(high, interval.high(), 5e-5);
  }

  @Test
  void theEndsAreExactAndBothSidesAlike() {
    for (int trials = 1; trials <= 30; trials++) {
      assertEquals(0, WilsonInterval.of(0, trials).orElseThrow().low());
      assertEquals(1, WilsonInterval.of(trials, trials).orElseThrow().high());
      for (int successes = 0; successes <= trials; successes++) {
        WilsonInterval one = WilsonInterval.of(successes, trials).orElseThrow();
        WilsonInterval other = WilsonInterval.of(trials - successes, trials).orElseThrow();
        assertEquals(one.low(), 1 - other.high(), 1e-12);
      }
    }
  }

  @Test
  void whereNothingWasTriedThereIsNone() {
    assertEquals(Optional.empty(), WilsonInterval.of(0, 0));
    assertThrows(IllegalArgumentException.class, () -> WilsonInterval.of(2, 1));
  }
}

package dev.eventchain.simulation.strength;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the size of standard faults: that of the unit, or a part of what the number has. */
class MagnitudeTest {

  @ParameterizedTest
  @CsvSource({
    "m, 0, 100, 2, 1",
    "cm, 0, 100, 2, 100",
    "s, 0, 100, 2, 0.5",
    "ms, 0, 100, 2, 500",
    "m/s, 0, 30, 3.6, 1",
    "km/h, 0, 100, 3.6, 3.6",
    "m/s2, -9, 0, 2, 1",
    "deg, -90, 90, 57.29577951308232, 5",
    "rad, -1, 1, 57.29577951308232, 0.08726646259971647",
    "1, 0, 1, 2, 0.2",
    "%, 0, 50, 2, 10",
    "'', -10, 10, 2, 4",
    "'', 5, 5, 2, 1",
    "'', 0, 0, 2, 0.2",
    "furlongs, 0, 5, 2, 1",
    "degC, 20, 30, 2, 2"
  })
  void dependsOnTheUnit(String unit, double least, double most, double factor, double shift) {
    Magnitude size = Magnitude.of(unit, least, most);
    assertEquals(factor, size.factor(), 1e-9);
    assertEquals(shift, size.shift(), 1e-9);
  }
}

package dev.eventchain.messages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class UnitConversionTest {

  private static UnitConversion between(String from, String to) {
    return UnitConversion.between(from, to)
        .orElseThrow(() -> new AssertionError("nothing converts " + from + " to " + to));
  }

  @ParameterizedTest
  @CsvSource({
    "km/h, m/s, / 3.6, 36, 10",
    "m/s, km/h, * 3.6, 10, 36",
    "%, 1, / 100.0, 29, 0.29",
    "ratio, percent, * 100.0, 0.5, 50",
    "mph, km/h, * 1.609344, 100, 160.9344",
    "degC, K, + 273.15, 20, 293.15",
    "K, degC, - 273.15, 300, 26.85",
    "degC, degF, * 1.8 + 32.0, 100, 212",
    "degF, degC, / 1.8 - 17.7777777778, 212, 100",
    "deg, rad, * 0.017453292519943295, 180, 3.141592653589793",
    "rad, deg, * 57.29577951308232, 3.141592653589793, 180",
    "kPa, bar, / 100.0, 250, 2.5",
    "us, s, / 1000000.0, 5, 0.000005",
    "s, ns, * 1.0e9, 2, 2000000000",
    "km/h, kmh, * 1.0, 7, 7",
    "K/s, degC/s, * 1.0, 7, 7",
    "%, percent, * 1.0, 50, 50",
  })
  void numbersAreConvertedAsTheOperatorsSay(
      String from, String to, String operators, double number, double expected) {
    UnitConversion conversion = between(from, to);
    assertEquals(operators, conversion.operators());
    assertEquals(expected, conversion.apply(number), 1e-9 * Math.max(1.0, Math.abs(expected)));
    assertEquals(number, between(to, from).apply(expected), 1e-9 * Math.max(1.0, Math.abs(number)));
  }

  @ParameterizedTest
  @CsvSource({"m/s, m", "rad, 1", "furlong, m", "m, furlong", "deg, %"})
  void nothingConvertsOtherDimensionsAndWhatIsUnknown(String from, String to) {
    assertTrue(UnitConversion.between(from, to).isEmpty());
  }
}

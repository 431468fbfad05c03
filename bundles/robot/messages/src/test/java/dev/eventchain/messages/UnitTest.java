package dev.eventchain.messages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class UnitTest {

  private static Unit unit(String text) {
    return Unit.parse(text).orElseThrow(() -> new AssertionError("not understood: " + text));
  }

  @ParameterizedTest
  @CsvSource({
    "m/s2, m/s^2",
    "m/s2, m.s-2",
    "m/s2, m·s⁻²",
    "m/s2, m/s/s",
    "m/s2, m/s**2",
    "m/s2, m*s^-2",
    "m/s2, ' m/s² '",
    "1/s, Hz",
    "/s, Hz",
    "km/h, kmh",
    "m / s, m/s",
    "mm, m/1000",
    "N, kg.m/s2",
    "Nm, N.m",
    "J/(kg.K), m2/(s2.K)",
    "V.A, W",
    "kPa, 10.hPa",
    "µs, us",
    "°C, degC",
    "K/s, degC/s",
    "B, byte",
    "%, percent",
    "mph, mi/h",
    "kilopascal, kPa",
    "kilopascals, kPa",
    "hertz, Hz",
    "kilograms, kg",
    "millivolts, mV",
    "terawatts, TW",
    "meters/second, m/s",
    "celsius, degC",
  })
  void spellingsOfTheSame(String first, String second) {
    assertEquals(Unit.Relation.SAME, unit(first).relationTo(unit(second)));
    assertEquals(Unit.Relation.SAME, unit(second).relationTo(unit(first)));
  }

  @ParameterizedTest
  @CsvSource({
    "m/s, km/h, multiply by 3.6",
    "km/h, m/s, divide by 3.6",
    "ms, s, divide by 1000",
    "s, ns, multiply by 1000000000",
    "deg, rad, divide by 57.29577951",
    "K, degC, subtract 273.15",
    "degC, K, add 273.15",
    "degC, degF, 'multiply by 1.8, then add 32'",
    "degF, degC, 'divide by 1.8, then subtract 17.77777778'",
    "%, 1, divide by 100",
    "bar, kPa, multiply by 100",
    "rpm, rad/s, divide by 9.549296586",
    "kWh, J, multiply by 3600000",
    "minutes, milliseconds, multiply by 60000",
    "kilometers, m, multiply by 1000",
  })
  void conversionsAreSaid(String from, String to, String words) {
    assertEquals(Unit.Relation.CONVERTIBLE, unit(from).relationTo(unit(to)));
    assertEquals(words, unit(from).conversionTo(unit(to)));
  }

  @ParameterizedTest
  @CsvSource({"m/s, m/s2", "m, s", "N, Nm", "1, m", "rad, m", "Hz, s", "byte, 1"})
  void otherDimensions(String first, String second) {
    assertEquals(Unit.Relation.INCOMPATIBLE, unit(first).relationTo(unit(second)));
  }

  @ParameterizedTest
  @CsvSource({"rad, 1", "rad/s, Hz", "deg, %", "rpm, 1/min"})
  void anglesThatMayBeMissing(String first, String second) {
    assertEquals(Unit.Relation.ANGLE, unit(first).relationTo(unit(second)));
    assertEquals(Unit.Relation.ANGLE, unit(second).relationTo(unit(first)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " ",
        "furlong",
        "kilofurlongs",
        "kilo",
        "kilokilometers",
        "KM/H",
        "C",
        "dB",
        "m/",
        "m//s",
        "(m",
        "m)",
        "m^",
        "m^x",
        "0",
        "m s2 )",
        "/",
        "-",
        "((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((",
        "Tm99.Tm99.Tm99",
      })
  void whatIsNotUnderstoodIsNoUnit(String text) {
    assertEquals(Optional.empty(), Unit.parse(text));
  }

  /** To the nearest double: 29 % is 0.29, which 29 times 0.01 is not. */
  @ParameterizedTest
  @CsvSource({"29, %, 0.29", "250, ms, 0.25", "36, km/h, 10", "0, degC, 273.15", "7, cm, 0.07"})
  void numbersInCoherentUnits(double number, String unit, double expected) {
    assertEquals(expected, Unit.parse(unit).orElseThrow().coherent(number));
  }

  @ParameterizedTest
  @CsvFileSource(resources = "/units.csv")
  void unitsAreThoseOfTheirDefinitions(String text, String si, double number, double coherent) {
    Unit unit = unit(text);
    Unit other = unit(si);
    assertTrue(
        EnumSet.of(Unit.Relation.SAME, Unit.Relation.CONVERTIBLE).contains(unit.relationTo(other)));
    assertEquals(coherent, other.coherent(coherent), "the second unit is coherent");
    assertEquals(coherent, unit.coherent(number), 1e-12 * Math.abs(coherent));
    assertEquals(number, unit.ofCoherent(coherent), 1e-12 * Math.max(273.15, Math.abs(number)));
  }

  @ParameterizedTest
  @CsvFileSource(resources = "/units.csv")
  void numbersComeBackFromTheCoherentUnit(String text) {
    Unit unit = unit(text);
    for (double number : new double[] {-273, -40, -1, 0, 1e-6, 0.1, 1, 29, 100, 255, 65535, 1e9}) {
      double back = unit.ofCoherent(unit.coherent(number));
      assertEquals(number, back, 1e-12 * Math.max(1000, Math.abs(number)), text);
    }
  }

  @Test
  void productsAndQuotientsHaveUnits() {
    Unit metre = Unit.parse("m").orElseThrow();
    Unit second = Unit.parse("s").orElseThrow();
    assertEquals(
        Unit.Relation.SAME, metre.times(second, -1).relationTo(Unit.parse("m/s").orElseThrow()));
  }

  @Test
  void whatIsListedIsUnderstood() {
    Unit.common().forEach(UnitTest::unit);
    Unit.symbols().forEach(UnitTest::unit);
    assertTrue(Unit.symbols().containsAll(List.of("m", "Pa", "kmh", "degC")));
  }
}

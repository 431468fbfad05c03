package dev.eventchain.messages;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Symbols of units, and the prefixes that some of them take. C and F are excluded, since they are
 * in use for degrees.
 */
final class UnitTable {

  private static final int METRE = 0;
  private static final int KILOGRAM = 1;
  private static final int SECOND = 2;
  private static final int AMPERE = 3;
  private static final int KELVIN = 4;

  /**
   * Index of the angle, a separate dimension here unlike in the SI: a number in rad and one in Hz
   * or per cent must not be interchangeable.
   */
  static final int ANGLE = 5;

  private static final int BYTE = 6;
  private static final int CANDELA = 7;
  private static final int DIMENSIONS = 8;

  /** The international pound in kg, and standard gravity in m/s2; both are exact. */
  private static final double POUND = 0.45359237;

  private static final double GRAVITY = 9.80665;

  private static final Map<String, Unit> PLAIN = new HashMap<>();
  private static final Map<String, Unit> PREFIXED = new HashMap<>();
  private static final Map<String, Double> PREFIXES =
      Map.ofEntries(
          Map.entry("n", 1e-9),
          Map.entry("u", 1e-6),
          Map.entry("\u00b5", 1e-6),
          Map.entry("\u03bc", 1e-6),
          Map.entry("m", 1e-3),
          Map.entry("c", 1e-2),
          Map.entry("d", 1e-1),
          Map.entry("h", 1e2),
          Map.entry("k", 1e3),
          Map.entry("M", 1e6),
          Map.entry("G", 1e9),
          Map.entry("T", 1e12));

  /** Prefixes and units that are spelled out, in the singular. */
  private static final Map<String, String> PREFIX_WORDS =
      Map.ofEntries(
          Map.entry("nano", "n"),
          Map.entry("micro", "u"),
          Map.entry("milli", "m"),
          Map.entry("centi", "c"),
          Map.entry("deci", "d"),
          Map.entry("hecto", "h"),
          Map.entry("kilo", "k"),
          Map.entry("mega", "M"),
          Map.entry("giga", "G"),
          Map.entry("tera", "T"));

  private static final Map<String, String> WORDS =
      Map.ofEntries(
          Map.entry("meter", "m"),
          Map.entry("metre", "m"),
          Map.entry("gram", "g"),
          Map.entry("second", "s"),
          Map.entry("ampere", "A"),
          Map.entry("kelvin", "K"),
          Map.entry("candela", "cd"),
          Map.entry("hertz", "Hz"),
          Map.entry("newton", "N"),
          Map.entry("joule", "J"),
          Map.entry("watt", "W"),
          Map.entry("pascal", "Pa"),
          Map.entry("volt", "V"),
          Map.entry("ohm", "Ohm"),
          Map.entry("liter", "l"),
          Map.entry("litre", "l"));

  /** Symbols that take small prefixes: dB is not a tenth of a byte. */
  private static final Set<String> SMALL_STEPS = Set.of("m", "g", "l", "L", "Pa");

  /** The empty product. */
  static final Unit ONE = new Unit(new int[DIMENSIONS], 1.0, 0.0);

  static {
    prefixed(1.0, METRE, 1, "m");
    prefixed(1e-3, KILOGRAM, 1, "g");
    prefixed(1.0, SECOND, 1, "s");
    prefixed(1.0, AMPERE, 1, "A");
    prefixed(1.0, KELVIN, 1, "K");
    prefixed(1.0, ANGLE, 1, "rad");
    prefixed(1.0, BYTE, 1, "B", "byte", "Byte", "By");
    prefixed(0.125, BYTE, 1, "bit");
    prefixed(1.0, CANDELA, 1, "cd");
    prefixed(1.0, SECOND, -1, "Hz");
    derived(1.0, "N", 1, 1, -2, 0);
    derived(1.0, "Nm", 2, 1, -2, 0);
    derived(1.0, "J", 2, 1, -2, 0);
    derived(1.0, "W", 2, 1, -3, 0);
    derived(1.0, "Pa", -1, 1, -2, 0);
    derived(1e5, "bar", -1, 1, -2, 0);
    derived(1.0, "V", 2, 1, -3, -1);
    derived(1.0, "Ohm", 2, 1, -3, -2);
    derived(1.0, "\u03a9", 2, 1, -3, -2);
    derived(1.0, "ohm", 2, 1, -3, -2);
    derived(1.0, "T", 0, 1, -2, -1);
    derived(3600.0, "Ah", 0, 0, 1, 1);
    derived(3600.0, "Wh", 2, 1, -2, 0);
    derived(1e-3, "l", 3, 0, 0, 0);
    derived(1e-3, "L", 3, 0, 0, 0);
    plain(0.0254, METRE, "in", "inch");
    plain(0.3048, METRE, "ft");
    plain(1609.344, METRE, "mi");
    plain(1000.0, KILOGRAM, "t");
    plain(POUND, KILOGRAM, "lb", "lbs");
    plain(1.0, SECOND, "sec");
    plain(60.0, SECOND, "min", "minute", "minutes");
    plain(3600.0, SECOND, "h", "hour", "hours");
    plain(86400.0, SECOND, "d", "day", "days");
    plain(604800.0, SECOND, "week", "weeks");
    plain(1.0, ANGLE, "radian", "radians");
    plain(Math.PI / 180.0, ANGLE, "deg", "degree", "degrees", "\u00b0");
    plain(1.0, BYTE, "bytes");
    temperature(1.0, 273.15, "degC", "\u00b0C", "Cel", "celsius");
    temperature(5.0 / 9.0, 273.15 - 32.0 * 5.0 / 9.0, "degF", "\u00b0F");
    PLAIN.put("%", new Unit(new int[DIMENSIONS], 0.01, 0.0));
    PLAIN.put("percent", PLAIN.get("%"));
    speed(1.0, "mps");
    speed(1.0 / 3.6, "kmh", "kph");
    speed(0.44704, "mph");
    PLAIN.put("ratio", ONE);
    PLAIN.put("PS", new Unit(exponents(METRE, 2, KILOGRAM, 1, SECOND, -3), 75 * GRAVITY, 0.0));
    double inch = 0.0254;
    double psi = POUND * GRAVITY / (inch * inch);
    PLAIN.put("psi", new Unit(exponents(METRE, -1, KILOGRAM, 1, SECOND, -2), psi, 0.0));
    PLAIN.put("rpm", new Unit(exponents(ANGLE, 1, SECOND, -1), Math.PI / 30.0, 0.0));
  }

  private UnitTable() {}

  /** Returns the unit of a symbol with an optional prefix. */
  static Optional<Unit> find(String symbol) {
    Unit whole = PLAIN.getOrDefault(symbol, PREFIXED.get(symbol));
    if (whole != null || symbol.length() < 2) {
      return Optional.ofNullable(whole);
    }
    Optional<Unit> spelled = spelled(symbol);
    if (spelled.isPresent()) {
      return spelled;
    }
    String prefix = symbol.substring(0, 1);
    String rest = symbol.substring(1);
    boolean taken =
        PREFIXES.containsKey(prefix)
            && PREFIXED.containsKey(rest)
            && (!"cdh".contains(prefix) || SMALL_STEPS.contains(rest));
    return taken ? Optional.of(times(prefix, rest)) : Optional.empty();
  }

  /** Returns the unit of a word in the singular or plural, such as kilopascal or hertz. */
  private static Optional<Unit> spelled(String text) {
    String word = text.endsWith("s") ? text.substring(0, text.length() - 1) : text;
    if (WORDS.containsKey(word)) {
      return Optional.of(PREFIXED.get(WORDS.get(word)));
    }
    return PREFIX_WORDS.entrySet().stream()
        .filter(it -> word.startsWith(it.getKey()))
        .filter(it -> WORDS.containsKey(word.substring(it.getKey().length())))
        .map(it -> times(it.getValue(), WORDS.get(word.substring(it.getKey().length()))))
        .findFirst();
  }

  /** Returns the symbols without a prefix, in the order of their letters. */
  static List<String> symbols() {
    return Stream.concat(PLAIN.keySet().stream(), PREFIXED.keySet().stream()).sorted().toList();
  }

  private static Unit times(String prefix, String symbol) {
    return number(PREFIXES.get(prefix)).times(PREFIXED.get(symbol), 1);
  }

  static Unit number(double value) {
    return new Unit(new int[DIMENSIONS], value, 0.0);
  }

  private static void prefixed(double scale, int dimension, int exponent, String... symbols) {
    for (String symbol : symbols) {
      PREFIXED.put(symbol, new Unit(exponents(dimension, exponent), scale, 0.0));
    }
  }

  private static void derived(
      double scale, String symbol, int metre, int kilogram, int second, int ampere) {
    int[] exponents = exponents(METRE, metre, KILOGRAM, kilogram, SECOND, second, AMPERE, ampere);
    PREFIXED.put(symbol, new Unit(exponents, scale, 0.0));
  }

  private static void plain(double scale, int dimension, String... symbols) {
    for (String symbol : symbols) {
      PLAIN.put(symbol, new Unit(exponents(dimension, 1), scale, 0.0));
    }
  }

  private static void temperature(double scale, double offset, String... symbols) {
    for (String symbol : symbols) {
      PLAIN.put(symbol, new Unit(exponents(KELVIN, 1), scale, offset));
    }
  }

  private static void speed(double scale, String... symbols) {
    for (String symbol : symbols) {
      PLAIN.put(symbol, new Unit(exponents(METRE, 1, SECOND, -1), scale, 0.0));
    }
  }

  private static int[] exponents(int... pairs) {
    int[] exponents = new int[DIMENSIONS];
    for (int i = 0; i < pairs.length; i += 2) {
      exponents[pairs[i]] = pairs[i + 1];
    }
    return exponents;
  }
}

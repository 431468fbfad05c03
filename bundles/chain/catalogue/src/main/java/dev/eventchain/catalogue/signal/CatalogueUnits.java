package dev.eventchain.catalogue.signal;

import java.util.Map;

/** Units of catalogues in the notation of all other units here. */
public final class CatalogueUnits {

  /** Those that are written otherwise; a time in words has none. */
  private static final Map<String, String> OTHERWISE =
      Map.of(
          "percent", "%",
          "degrees", "deg",
          "degrees/s", "deg/s",
          "Celsius", "degC",
          "celsius", "degC",
          "iso8601", "",
          "cpm", "1/min",
          "bpm", "1/min",
          "l/100km", "l/(100.km)",
          "kWh/100km", "kWh/(100.km)");

  private CatalogueUnits() {}

  /** Returns whether a text is what tools write where there is no unit. */
  public static boolean isNone(String written) {
    return written.matches("(?i)-?|n/?a|none|unitless|no_?unit");
  }

  /** Returns a unit in that notation; empty for an empty one. */
  public static String of(String written) {
    return OTHERWISE.getOrDefault(written, written);
  }
}

package dev.eventchain.roads.geo;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The projection of a map: {@code +proj=tmerc} or {@code +proj=utm} on the ellipsoid of WGS 84, in
 * metres. All else is refused by its name.
 */
public final class GeoReference {

  /** Parameters that say nothing of the plane. Heights of a geoid concern heights only. */
  private static final Set<String> WITHOUT_EFFECT =
      Set.of("no_defs", "type", "wktext", "vunits", "geoidgrids", "geoid_crs");

  /** Values that say what is so anyway. */
  private static final Map<String, Set<String>> USUAL =
      Map.of(
          // Places on both ellipsoids are within 1 mm of each other.
          "ellps", Set.of("WGS84", "GRS80"),
          "datum", Set.of("WGS84"),
          "units", Set.of("m"),
          "to_meter", Set.of("1"),
          "axis", Set.of("enu"),
          "towgs84", Set.of("0,0,0", "0,0,0,0,0,0,0"));

  private static final Set<String> NUMBERS =
      Set.of("lat_0", "lon_0", "k", "k_0", "x_0", "y_0", "zone");

  private static final double UTM_SCALE = 0.9996;
  private static final double UTM_EAST = 500_000;
  private static final double UTM_NORTH_OF_SOUTH = 10_000_000;
  private static final int UTM_ZONES = 60;

  private final Map<String, Double> numbers = new LinkedHashMap<>();
  private boolean utm;
  private boolean south;
  private String problem = "";

  /** Reads a PROJ string. */
  public GeoReference(String text) {
    Map<String, String> parameters = new LinkedHashMap<>();
    for (String word : text.strip().split("\\s+", -1)) {
      String[] pair = word.split("=", 2);
      if (!word.startsWith("+")) {
        refuse(text.isBlank() ? "there is none" : "`" + text.strip() + "` is no PROJ string");
        return;
      }
      parameters.put(pair[0].substring(1), pair.length > 1 ? pair[1] : "");
    }
    String projection = parameters.getOrDefault("proj", "");
    utm = projection.equals("utm");
    if (!utm && !projection.equals("tmerc")) {
      refuse("the projection `" + projection + "` is not known, only `tmerc` and `utm` are");
    }
    parameters.remove("proj");
    parameters.forEach(this::read);
    if (utm && !isZone(numbers.getOrDefault("zone", 0.0))) {
      refuse("`utm` needs a `zone` from 1 to " + UTM_ZONES);
    }
  }

  private static boolean isZone(double zone) {
    return zone >= 1 && zone <= UTM_ZONES && zone == Math.rint(zone);
  }

  private void read(String name, String value) {
    if (name.equals("south") && utm) {
      south = true;
    } else if (NUMBERS.contains(name)) {
      try {
        numbers.put(name, Double.valueOf(value));
      } catch (NumberFormatException e) {
        refuse("`" + name + "=" + value + "` is no number");
      }
    } else if (!WITHOUT_EFFECT.contains(name)
        && !USUAL.getOrDefault(name, Set.of()).contains(value)) {
      refuse("`+" + name + (value.isEmpty() ? "" : "=" + value) + "` is not known");
    }
  }

  private void refuse(String reason) {
    if (problem.isEmpty()) {
      problem = reason;
    }
  }

  /** Returns why it gives no places, as the end of a sentence; empty if it does. */
  public Optional<String> problem() {
    return Optional.of(problem).filter(reason -> !reason.isEmpty());
  }

  private double number(String name, double otherwise) {
    return numbers.getOrDefault(name, otherwise);
  }

  /**
   * Returns the coordinates to the east and to the north, in m.
   *
   * @param latitude in degrees
   * @param longitude in degrees
   */
  public double[] project(double latitude, double longitude) {
    double meridian = utm ? 6 * number("zone", 0) - 183 : number("lon_0", 0);
    double scale = utm ? UTM_SCALE : number("k_0", number("k", 1));
    double east = utm ? UTM_EAST : number("x_0", 0);
    double north = utm ? 0 : number("y_0", 0);
    double parallel = utm ? 0 : number("lat_0", 0);
    double[] place =
        TransverseMercator.project(Math.toRadians(latitude), Math.toRadians(longitude - meridian));
    double origin = TransverseMercator.project(Math.toRadians(parallel), 0)[1];
    return new double[] {
      east + scale * place[0],
      north + (south ? UTM_NORTH_OF_SOUTH : 0) + scale * (place[1] - origin)
    };
  }
}

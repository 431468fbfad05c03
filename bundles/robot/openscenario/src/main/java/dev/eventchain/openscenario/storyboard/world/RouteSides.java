package dev.eventchain.openscenario.storyboard.world;

import java.util.Locale;
import java.util.Optional;

/**
 * Side that a lane and a t of a {@code RoutePosition} mean where the route leads against the s of
 * the road. The standard does not say it, and programs differ.
 */
public enum RouteSides {
  /** The side that they have on the road. */
  ROAD,
  /** The side that they have as one looks along the route: to the right below 0. */
  ROUTE;

  /** Default reading. */
  public static final RouteSides USUAL = ROUTE;

  /** Returns the word of a setting. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns that of a word; empty if it is none. */
  public static Optional<RouteSides> of(String word) {
    for (RouteSides each : values()) {
      if (each.word().equals(word)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }
}

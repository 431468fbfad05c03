package dev.eventchain.roads.road;

import java.util.Locale;
import java.util.Optional;

/**
 * Successor at an end of a road.
 *
 * @param junction whether it is a junction and no road
 * @param id the id of the road or junction
 * @param contact the end of the road that is linked; empty for a junction
 */
public record RoadLink(boolean junction, String id, Optional<Contact> contact) {

  /** An end of a road. */
  public enum Contact {
    /** Point where s is 0. */
    START,
    /** Point where s is the road's length. */
    END;

    /** Returns its name in OpenDRIVE. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT);
    }
  }
}

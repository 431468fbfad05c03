package dev.eventchain.simulation.world;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Kinds of actors and furniture, with their default sizes, which are typical or those of the named
 * source.
 */
public enum ActorKind {
  /** A passenger car of the compact class. */
  CAR(true, 4.5, 1.8, 0.0, 1.5, 0.8f),
  /** A rigid lorry of the largest size that Directive 96/53/EC allows. */
  LORRY(true, 12.0, 2.55, 0.0, 4.0, 0.8f),
  /** A motorcycle with its rider. */
  MOTORCYCLE(true, 2.1, 0.8, 0.0, 1.4, 0.6f),
  /** A bicycle with its rider, as the target of ISO 19206-4. */
  BICYCLE(true, 1.9, 0.5, 0.0, 1.85, 0.5f),
  /** A walking adult, as the target of ISO 19206-2. */
  PEDESTRIAN(true, 0.6, 0.5, 0.0, 1.8, 0.4f),
  /** A passenger car that stands next to the lane. */
  PARKED_CAR(false, 4.5, 1.8, 0.0, 1.5, 0.8f),
  /** A sign on a gantry, with the clearance over motorways of German RWBA (5.0 m). */
  OVERHEAD_SIGN(false, 0.3, 6.0, 5.0, 7.5, 0.9f),
  /** A bridge over the road with the clearance of German roads (RAA 2008: 4.70 m). */
  BRIDGE(false, 12.0, 40.0, 4.7, 6.0, 0.4f),
  /** A steel barrier of the usual height for EN 1317. */
  GUARD_RAIL(false, 40.0, 0.3, 0.0, 0.75, 0.7f),
  /** A plate over a trench, to be driven over. */
  STEEL_PLATE(false, 3.0, 2.5, 0.0, 0.03, 0.7f),
  /** Any other box on the road, such as lost cargo. */
  OBSTACLE(false, 1.0, 1.0, 0.0, 1.0, 0.5f);

  private final boolean moves;
  private final double length;
  private final double width;
  private final double bottom;
  private final double top;
  private final float intensity;

  ActorKind(
      boolean moves, double length, double width, double bottom, double top, float intensity) {
    this.moves = moves;
    this.length = length;
    this.width = width;
    this.bottom = bottom;
    this.top = top;
    this.intensity = intensity;
  }

  /** Returns the name in a scenario. */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns whether it is furniture, which stands. */
  public boolean isFurniture() {
    return !moves;
  }

  /** Returns the names of the moving kinds, or of the others. */
  public static List<String> ids(boolean moving) {
    return Arrays.stream(values()).filter(kind -> kind.moves == moving).map(ActorKind::id).toList();
  }

  /** Finds one of the moving kinds, or of the others. */
  public static Optional<ActorKind> find(String id, boolean moving) {
    return Arrays.stream(values())
        .filter(kind -> kind.moves == moving && kind.id().equals(id))
        .findFirst();
  }

  public Actor.Size size() {
    return new Actor.Size(length, width, bottom, top);
  }

  /** Returns the intensity of a lidar's echo, 0 to 1; for display only, not measured. */
  float intensity() {
    return intensity;
  }
}

package dev.eventchain.openscenario.storyboard.world;

/** Observers that see an entity: the pictures, sensors, and the other entities. */
public record Visibility(boolean graphics, boolean sensors, boolean traffic) {

  /** That of an entity of which nothing else is said. */
  public static final Visibility ALL = new Visibility(true, true, true);
}

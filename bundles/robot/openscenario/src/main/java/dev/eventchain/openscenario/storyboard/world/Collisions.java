package dev.eventchain.openscenario.storyboard.world;

/** Entities that are in contact at a moment. */
@FunctionalInterface
public interface Collisions {

  /** No contacts. */
  Collisions NONE = (first, second) -> false;

  /** Returns whether two entities touch; the order does not matter. */
  boolean touch(String first, String second);
}

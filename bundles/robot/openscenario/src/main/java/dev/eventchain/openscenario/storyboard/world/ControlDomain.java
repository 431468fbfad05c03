package dev.eventchain.openscenario.storyboard.world;

/** A part of the motion of an entity that something controls. */
public enum ControlDomain {
  /** Its speed. */
  LONGITUDINAL,
  /** Its way. */
  LATERAL
}

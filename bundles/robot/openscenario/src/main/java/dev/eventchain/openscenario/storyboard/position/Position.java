package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.storyboard.scene.Scene;

/** A position that may be relative to what moves. */
@FunctionalInterface
public interface Position {

  /**
   * Returns where it is now.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if there is no such place
   */
  Placement in(Scene scene);
}

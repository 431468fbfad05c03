package dev.eventchain.openscenario.storyboard.scene;

/** Control of the speed of an entity. Immutable. */
public interface Longitudinal {

  /** Keeps the speed that the entity has. */
  Longitudinal KEEP =
      (scene, actor, dt) -> Step.of(actor.state().speed() * dt, actor.state().speed(), 0);

  /**
   * A step.
   *
   * @param distance the way during the step, in m; negative backward
   * @param speed at the end of the step, in m/s
   * @param acceleration at the end of the step, in m/s2
   * @param next what decides the next step
   * @param done whether the aim is reached
   */
  record Step(double distance, double speed, double acceleration, Longitudinal next, boolean done) {

    /** Returns a step after which the speed is kept, and which is never an aim. */
    public static Step of(double distance, double speed, double acceleration) {
      return new Step(distance, speed, acceleration, KEEP, false);
    }
  }

  /**
   * Returns a step from now.
   *
   * @param scene others are where they are at the beginning of the step
   */
  Step step(Scene scene, Actor actor, double dt);
}

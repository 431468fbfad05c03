package dev.eventchain.simulation.world;

import java.util.List;

/**
 * Moves the actors of one run and drives the ego until the software does: what a scenario of
 * another format plays. It continues from moment to moment of the trace.
 */
public interface Director {

  /**
   * The ego at a moment.
   *
   * @param front the middle of its front bumper, and its heading
   * @param velocity along its own axis, in m/s; negative backwards
   * @param acceleration along its own axis, in m/s2
   * @param yawRate in rad/s, positive to the left
   * @param pedals whether the software has the pedals
   * @param wheel whether the software has the wheel
   */
  record Ego(
      Road.Place front,
      double velocity,
      double acceleration,
      double yawRate,
      boolean pedals,
      boolean wheel) {}

  /** Begins anew, so that several runs do not depend on each other. */
  @FunctionalInterface
  interface Source {
    Director begin();

    /** Returns the names of the events that may happen, in the order of the scenario. */
    default List<String> events() {
      return List.of();
    }
  }

  /**
   * The begin or the end of an event.
   *
   * @param time in ns
   */
  record Happening(String event, boolean begins, long time) {}

  /** Returns all actors, also those that are not there; the same ones at each moment. */
  List<Actor> actors();

  /**
   * Continues at a moment: afterwards, the tracks of the actors reach to the next one.
   *
   * @param moment its number, from 0, each one once
   */
  void continueAt(int moment, Ego ego);

  /** Returns the acceleration at which the ego drives until the next moment, in m/s2. */
  double acceleration();

  /** Returns the curvature that the ego drives until then, in 1/m, positive to the left. */
  double curvature();

  /** Returns what happened up to now, in its order. */
  List<Happening> happenings();

  /** Returns whether the scenario ended. */
  boolean ended();

  /** Returns what should have happened by now and did not, in words. */
  List<String> neverBegun();
}

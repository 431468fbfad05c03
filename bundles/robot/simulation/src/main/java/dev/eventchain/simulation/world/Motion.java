package dev.eventchain.simulation.world;

import java.util.List;

/**
 * A script: the speed and the offset as far as their times are known, and the maneuvers that have
 * not begun. Immutable.
 *
 * @param latest when the last maneuver began, in ns
 */
public record Motion(SpeedProfile speed, LateralProfile line, long latest, List<Maneuver> waiting) {

  public Motion {
    waiting = List.copyOf(waiting);
  }

  /** Returns a script whose times are all known. */
  static Motion of(SpeedProfile speed, LateralProfile line) {
    return new Motion(speed, line, 0, List.of());
  }

  /**
   * Returns the script with further maneuvers.
   *
   * @param begun when the last maneuver of a known time begins, in s
   */
  Motion then(double begun, List<Maneuver> maneuvers) {
    return new Motion(speed, line, World.nanoseconds(begun), maneuvers);
  }

  /** Returns whether a maneuver has not begun. */
  public boolean waits() {
    return !waiting.isEmpty();
  }

  /** Returns the script with the maneuvers that begin now. */
  Motion continued(long now, Trace moment) {
    Motion motion = this;
    while (motion.waits() && motion.begins(now, moment)) {
      motion = motion.begun(now);
    }
    return motion;
  }

  private boolean begins(long now, Trace moment) {
    if (now < latest) {
      return false; // the one before it has not begun
    }
    Maneuver.Start start = waiting.get(0).start();
    return start instanceof Maneuver.When when
        ? when.condition().test(moment)
        : now >= latest + ((Maneuver.After) start).time();
  }

  private Motion begun(long now) {
    Maneuver.Change change = waiting.get(0).change();
    List<Maneuver> rest = waiting.subList(1, waiting.size());
    double seconds = World.seconds(now);
    return change instanceof SpeedProfile.Change other
        ? new Motion(speed.then(other.at(seconds)), line, now, rest)
        : new Motion(speed, moved((LateralProfile.Change) change, seconds), now, rest);
  }

  private LateralProfile moved(LateralProfile.Change change, double seconds) {
    return line.then(change.at(Math.max(seconds, line.end())));
  }

  /** Returns whether nothing moves from a time on, in s. */
  boolean restsFrom(double seconds) {
    return !waits() && speed.restsFrom(seconds) && line.restsFrom(seconds);
  }

  /** Returns an upper bound of the speed, in m/s, also in the maneuvers that have not begun. */
  public double fastest() {
    double fastest = Math.max(speed.fastest(), 0.0);
    for (Maneuver each : waiting) {
      if (each.change() instanceof SpeedProfile.Change change) {
        fastest = Math.max(fastest, change.speed());
      }
    }
    return fastest;
  }

  /** Returns an upper bound of the lateral speed likewise. */
  double fastestAside() {
    double fastest = line.fastest();
    for (Maneuver each : waiting) {
      if (each.change() instanceof LateralProfile.Change change) {
        fastest = Math.max(fastest, change.speed());
      }
    }
    return fastest;
  }
}

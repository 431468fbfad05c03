package dev.eventchain.simulation.world;

import java.util.ArrayList;
import java.util.List;

/** A speed that is constant or changes at constant rates; never negative. Immutable. */
public final class SpeedProfile {

  /**
   * A change of the speed to another one, in m/s, that begins at a time, in s, with a rate in m/s2
   * above 0.
   */
  public record Change(double time, double speed, double acceleration) implements Maneuver.Change {

    /** Returns the same change at another time, in s. */
    public Change at(double seconds) {
      return new Change(seconds, speed, acceleration);
    }
  }

  /** A part of constant acceleration, which may be negative, from a time on. */
  private record Piece(double time, double speed, double rate, double way) {

    double speedAt(double seconds) {
      return Math.max(0.0, speed + rate * (seconds - time));
    }

    double wayAt(double seconds) {
      double since = seconds - time;
      return way + speed * since + 0.5 * rate * since * since;
    }
  }

  private final double start;
  private final List<Change> changes;
  private final List<Piece> pieces = new ArrayList<>();
  private final double fastest;

  /**
   * Creates a profile.
   *
   * @param start speed at the start, in m/s
   * @param changes in the order of time; a change that begins before the end of the previous one
   *     begins at the speed of that moment
   */
  public SpeedProfile(double start, List<Change> changes) {
    this.start = start;
    this.changes = List.copyOf(changes);
    pieces.add(new Piece(0.0, start, 0.0, 0.0));
    for (Change change : changes) {
      while (last().time() > change.time()) {
        pieces.remove(pieces.size() - 1);
      }
      double speed = last().speedAt(change.time());
      double rate = Math.copySign(change.acceleration(), change.speed() - speed);
      pieces.add(new Piece(change.time(), speed, rate, last().wayAt(change.time())));
      double reached = change.time() + Math.abs(change.speed() - speed) / change.acceleration();
      pieces.add(new Piece(reached, change.speed(), 0.0, last().wayAt(reached)));
    }
    fastest = pieces.stream().mapToDouble(Piece::speed).max().orElseThrow();
  }

  /** Returns the speed at the start, in m/s. */
  public double start() {
    return start;
  }

  /** Returns the changes, in the order of time. */
  public List<Change> changes() {
    return changes;
  }

  /** Returns this profile with a further change, which begins after the others. */
  SpeedProfile then(Change change) {
    List<Change> all = new ArrayList<>(changes);
    all.add(change);
    return new SpeedProfile(start, all);
  }

  private Piece last() {
    return pieces.get(pieces.size() - 1);
  }

  private Piece at(double seconds) {
    int index = pieces.size() - 1;
    while (index > 0 && pieces.get(index).time() > seconds) {
      index--;
    }
    return pieces.get(index);
  }

  /** Returns the speed after some seconds, in m/s. */
  public double speed(double seconds) {
    return at(seconds).speedAt(seconds);
  }

  /** Returns the acceleration after some seconds, in m/s2. */
  double acceleration(double seconds) {
    return at(seconds).rate();
  }

  /** Returns whether it is 0 from a time on, in s. */
  boolean restsFrom(double seconds) {
    return speed(seconds) == 0.0
        && pieces.stream()
            .filter(each -> each.time() >= seconds)
            .allMatch(each -> each.speed() == 0.0 && each.rate() == 0.0);
  }

  /** Returns the distance since the start, in m. */
  public double way(double seconds) {
    return at(seconds).wayAt(seconds);
  }

  /** Returns the largest speed, in m/s. */
  double fastest() {
    return fastest;
  }
}

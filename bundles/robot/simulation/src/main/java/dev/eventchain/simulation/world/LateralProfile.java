package dev.eventchain.simulation.world;

import java.util.ArrayList;
import java.util.List;

/**
 * An offset from the centre of a lane that is constant or changes to another one, along half a
 * cosine or at a constant speed. Immutable.
 */
public final class LateralProfile {

  /**
   * A change of the offset to another one, in m, that begins at a time, in s.
   *
   * @param speed the largest lateral speed in between, in m/s, above 0
   * @param linear true if the speed is the same all the way, false if it is half a wave
   */
  public record Change(double time, double offset, double speed, boolean linear)
      implements Maneuver.Change {

    /** Creates a change whose speed grows and falls along half a wave. */
    public Change(double time, double offset, double speed) {
      this(time, offset, speed, false);
    }

    @Override
    public Change at(double seconds) {
      return new Change(seconds, offset, speed, linear);
    }
  }

  private record Move(double time, double from, double to, double duration, boolean linear) {

    static Move of(Change change, double from) {
      double way = Math.abs(change.offset() - from);
      double duration = (change.linear() ? way : Math.PI / 2.0 * way) / change.speed();
      return new Move(change.time(), from, change.offset(), duration, change.linear());
    }

    double end() {
      return time + duration;
    }

    double at(double seconds) {
      double part = Math.min(1.0, (seconds - time) / duration);
      double done = linear ? part : (1.0 - StrictMath.cos(Math.PI * part)) / 2.0;
      return part >= 1.0 ? to : from + (to - from) * done;
    }

    double rate(double seconds) {
      double part = (seconds - time) / duration;
      double share = linear ? 1.0 : Math.PI / 2.0 * StrictMath.sin(Math.PI * part);
      return part >= 1.0 ? 0.0 : (to - from) / duration * share;
    }
  }

  private final double start;
  private final List<Change> changes;
  private final List<Move> moves = new ArrayList<>();
  private final double fastest;

  /**
   * Creates a profile.
   *
   * @param start offset at the start, in m
   * @param changes in the order of time, none before the end of the previous one
   */
  public LateralProfile(double start, List<Change> changes) {
    this.start = start;
    this.changes = List.copyOf(changes);
    double from = start;
    for (Change change : changes) {
      if (change.offset() != from) {
        moves.add(Move.of(change, from));
        from = change.offset();
      }
    }
    fastest = changes.stream().mapToDouble(Change::speed).max().orElse(0.0);
  }

  /** Returns this profile with a further change, which begins after the end of the others. */
  LateralProfile then(Change change) {
    List<Change> all = new ArrayList<>(changes);
    all.add(change);
    return new LateralProfile(start, all);
  }

  /** Returns whether the offset is constant. */
  boolean constant() {
    return moves.isEmpty();
  }

  private Move current(double seconds) {
    Move current = null;
    for (Move move : moves) {
      if (move.time() <= seconds) {
        current = move;
      }
    }
    return current;
  }

  /** Returns the offset after some seconds, in m. */
  double offset(double seconds) {
    Move current = current(seconds);
    return current == null ? start : current.at(seconds);
  }

  /** Returns the lateral speed after some seconds, in m/s. */
  double rate(double seconds) {
    Move current = current(seconds);
    return current == null ? 0.0 : current.rate(seconds);
  }

  /** Returns the end of the last change, in s; 0 if there is none. */
  public double end() {
    return moves.isEmpty() ? 0.0 : moves.get(moves.size() - 1).end();
  }

  /** Returns whether the offset is constant from a time on, in s. */
  boolean restsFrom(double seconds) {
    return end() <= seconds;
  }

  /** Returns the largest lateral speed, in m/s. */
  double fastest() {
    return fastest;
  }
}

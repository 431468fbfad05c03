package dev.eventchain.simulation.world;

import java.util.ArrayList;
import java.util.List;

/**
 * An offset from the centre of a lane that is constant or changes to another one. It changes along
 * half a cosine or at a constant speed, which is reached at once or at a constant acceleration.
 * Immutable.
 */
public final class LateralProfile {

  /**
   * A change of the offset to another one, in m, that begins at a time, in s.
   *
   * @param speed the largest lateral speed in between, in m/s, above 0
   * @param linear true if the speed is the same on the way, false if it is half a wave
   * @param acceleration at which the speed of a linear change grows and falls, in m/s2; infinite if
   *     it does so at once
   */
  public record Change(
      double time, double offset, double speed, boolean linear, double acceleration)
      implements Maneuver.Change {

    /** Creates a change whose speed grows and falls along half a wave. */
    public Change(double time, double offset, double speed) {
      this(time, offset, speed, false, Double.POSITIVE_INFINITY);
    }

    /** Returns the same change at another time, in s. */
    public Change at(double seconds) {
      return new Change(seconds, offset, speed, linear, acceleration);
    }
  }

  /**
   * A change on its way.
   *
   * @param time when it begins, in s
   * @param from the offset before, in m
   * @param to the offset after it, in m
   * @param duration in s
   * @param ramp how long the speed of a linear one grows, and how long it falls, in s
   */
  public record Move(
      double time, double from, double to, double duration, boolean linear, double ramp) {

    /** Returns the move of a change from an offset. */
    public static Move of(Change change, double from) {
      double way = Math.abs(change.offset() - from);
      if (!change.linear()) {
        double duration = Math.PI / 2.0 * way / change.speed();
        return new Move(change.time(), from, change.offset(), duration, false, 0.0);
      }
      // A short way ends before the speed is reached.
      double speed = Math.min(change.speed(), StrictMath.sqrt(change.acceleration() * way));
      double ramp = speed / change.acceleration();
      return new Move(change.time(), from, change.offset(), way / speed + ramp, true, ramp);
    }

    public double end() {
      return time + duration;
    }

    double at(double seconds) {
      double since = seconds - time;
      return since >= duration ? to : from + (to - from) * (linear ? share(since) : wave(since));
    }

    private double wave(double since) {
      return (1.0 - StrictMath.cos(Math.PI * since / duration)) / 2.0;
    }

    /** Returns the share of the way of a linear change. */
    private double share(double since) {
      double steady = duration - ramp;
      if (since < ramp) {
        return since * since / (2.0 * ramp * steady);
      }
      double left = duration - since;
      return left < ramp
          ? 1.0 - left * left / (2.0 * ramp * steady)
          : (since - ramp / 2.0) / steady;
    }

    double rate(double seconds) {
      double since = seconds - time;
      if (since >= duration) {
        return 0.0;
      }
      if (!linear) {
        double share = Math.PI / 2.0 * StrictMath.sin(Math.PI * since / duration);
        return (to - from) / duration * share;
      }
      double nearest = Math.min(since, duration - since);
      double share = nearest < ramp ? nearest / ramp : 1.0;
      return (to - from) / (duration - ramp) * share;
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

  /** Returns the changes, in the order of time, also those to the offset that is there. */
  public List<Change> changes() {
    return changes;
  }

  /** Returns the changes that move something, in the order of time. */
  public List<Move> moves() {
    return List.copyOf(moves);
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
  public double offset(double seconds) {
    Move current = current(seconds);
    return current == null ? start : current.at(seconds);
  }

  /** Returns the lateral speed after some seconds, in m/s. */
  public double rate(double seconds) {
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

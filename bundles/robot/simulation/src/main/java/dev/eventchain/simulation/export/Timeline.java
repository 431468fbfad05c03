package dev.eventchain.simulation.export;

import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.SpeedProfile;
import java.util.ArrayList;
import java.util.List;

/**
 * Actions that the parts of a script with known times become. A half wave to the side at a constant
 * speed is a lane change; everything else to the side is a part of a trajectory, together with the
 * changes of the speed during it.
 */
final class Timeline {

  /** Angle by which the direction of a vehicle may differ for a moment, in rad. */
  private static final double MOST_TURNED = 0.02;

  /** Time by which trajectories lead beyond the end, at which nothing is to change, in s. */
  private static final double BEYOND = 1.0;

  /** A time from which to which a trajectory leads, in s. */
  record Span(double from, double to) {

    boolean meets(double begin, double end) {
      return begin < to && end > from;
    }
  }

  private final Mover mover;
  private final double end;
  private final boolean isStraight;
  private final List<Span> trajectories = new ArrayList<>();
  private final List<LateralProfile.Move> laneChanges = new ArrayList<>();
  private final List<SpeedProfile.Change> speedChanges = new ArrayList<>();

  Timeline(Mover mover, double duration, boolean isStraight) {
    this.mover = mover;
    this.end = duration + BEYOND;
    this.isStraight = isStraight;
    List<Span> spans = new ArrayList<>();
    for (LateralProfile.Move move : mover.motion().line().moves()) {
      if (isLaneChange(move)) {
        laneChanges.add(move);
      } else if (move.time() < end) {
        spans.add(new Span(move.time(), Math.min(end, move.end())));
      }
    }
    if (isWayOfItsOwn()) {
      spans.clear();
      laneChanges.clear();
      spans.add(new Span(0.0, end));
    }
    merge(spans);
    for (SpeedProfile.Change change : mover.motion().speed().changes()) {
      if (trajectories.stream().noneMatch(it -> it.meets(change.time(), end(change)))) {
        speedChanges.add(change);
      }
    }
  }

  /** Returns whether it moves across the road, on no straight line, by its own direction. */
  private boolean isWayOfItsOwn() {
    boolean crosses = !mover.followsTheRoad() && mover.moves() && !mover.motion().waits();
    return crosses && (!isStraight || !mover.motion().line().moves().isEmpty());
  }

  private double end(SpeedProfile.Change change) {
    double before = mover.motion().speed().speed(change.time());
    double changes = Math.abs(change.speed() - before) / change.acceleration();
    return change.time() + Math.max(changes, 1e-9);
  }

  private void merge(List<Span> spans) {
    for (Span each : spans) {
      Span span = widened(each);
      Span last = trajectories.isEmpty() ? null : trajectories.get(trajectories.size() - 1);
      if (last != null && last.to() >= span.from()) {
        trajectories.remove(last);
        span = new Span(last.from(), Math.max(last.to(), span.to()));
      }
      trajectories.add(span);
    }
  }

  /** Returns a span that no change of the speed crosses. */
  private Span widened(Span span) {
    Span wide = span;
    for (int i = 0; i <= mover.motion().speed().changes().size(); i++) {
      for (SpeedProfile.Change change : mover.motion().speed().changes()) {
        if (wide.meets(change.time(), end(change))) {
          wide =
              new Span(
                  Math.min(wide.from(), change.time()),
                  Math.min(end, Math.max(wide.to(), end(change))));
        }
      }
    }
    return wide;
  }

  /** Returns how long the reference point is behind the scripted one, in s. */
  private double lag(LateralProfile.Move move) {
    return mover.reach() / mover.motion().speed().speed(move.time());
  }

  private boolean isLaneChange(LateralProfile.Move move) {
    SpeedProfile speed = mover.motion().speed();
    double driven = speed.speed(move.time());
    if (!isHalfWaveAhead(mover, move, driven, isStraight)) {
      return false;
    }
    double settled = move.end() + lag(move);
    return speed.changes().stream()
        .noneMatch(change -> change.time() < settled && end(change) > move.time());
  }

  /**
   * Returns whether a vehicle that keeps to a half wave with its reference point is where the
   * scripted one is: what it does to the side is slow beside its speed.
   *
   * @param driven its speed, in m/s
   */
  static boolean isHalfWaveAhead(
      Mover mover, LateralProfile.Move move, double driven, boolean isStraight) {
    double frequency = Math.PI / move.duration();
    double half = Math.abs(move.to() - move.from()) / 2;
    double hardest = half * frequency * frequency;
    // Its direction is late by the time from the reference point to the scripted one.
    return isStraight
        && !move.linear()
        && mover.direction() == 0.0
        && (mover.turns() || mover.reach() == 0.0)
        && driven * Mover.STEEPEST >= half * frequency
        && driven * driven * MOST_TURNED >= mover.reach() * hardest;
  }

  /** Returns when the reference point begins a lane change, in s. */
  double begin(LateralProfile.Move move) {
    return move.time() + lag(move);
  }

  List<Span> trajectories() {
    return trajectories;
  }

  List<LateralProfile.Move> laneChanges() {
    return laneChanges;
  }

  /** Returns the changes of the speed that are not parts of trajectories. */
  List<SpeedProfile.Change> speedChanges() {
    return speedChanges;
  }
}

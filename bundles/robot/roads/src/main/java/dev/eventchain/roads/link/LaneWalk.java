package dev.eventchain.roads.link;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;

/** Walk along linked lanes, from section to section. */
public final class LaneWalk {

  /** Sections of a walk after which it ends, as a loop of lanes nearly without length would not. */
  public static final int MOST_SECTIONS = 100_000;

  private final LaneGraph graph;

  /** Creates a walk along the lanes of a graph. */
  public LaneWalk(LaneGraph graph) {
    this.graph = graph;
  }

  /**
   * Returns the end at which the lane goes on: on the same road, or else where it goes on
   * straightest; empty if it does not.
   */
  public Optional<LaneEnd> straightest(LaneEnd exit) {
    return straightest(exit, graph.from(exit));
  }

  /** As {@link #straightest(LaneEnd)}, with the ends at which linked lanes begin. */
  public static Optional<LaneEnd> straightest(LaneEnd exit, List<LaneEnd> entries) {
    for (LaneEnd entry : entries) {
      if (exit.goesOnAt(entry)) {
        return Optional.of(entry);
      }
    }
    return entries.stream().min(Comparator.comparingDouble(LaneWalk::turn));
  }

  /** Returns by how much a road turns, in rad. */
  private static double turn(LaneEnd entry) {
    double length = entry.road().length();
    double turned = entry.road().heading(length) - entry.road().heading(0);
    return Math.abs(Math.IEEEremainder(turned, 2 * Math.PI));
  }

  /**
   * Returns what is at a distance along the reference lines of linked lanes; empty if the lanes end
   * before.
   *
   * @param exit the end of the first lane towards which it goes
   * @param s of the start
   * @param arrive makes the result of the end that comes next and s
   */
  public <T> Optional<T> along(
      LaneEnd exit, double s, double distance, BiFunction<LaneEnd, Double, T> arrive) {
    LaneEnd to = exit;
    double at = s;
    double left = distance;
    for (int i = 0; i < MOST_SECTIONS; i++) {
      double room = Math.abs(to.s() - at);
      if (left <= room) {
        return Optional.of(arrive.apply(to, at + Math.signum(to.s() - at) * left));
      }
      left -= room;
      Optional<LaneEnd> next = straightest(to);
      if (next.isEmpty()) {
        return Optional.empty();
      }
      to = next.get().other();
      at = next.get().s();
    }
    return Optional.empty();
  }
}

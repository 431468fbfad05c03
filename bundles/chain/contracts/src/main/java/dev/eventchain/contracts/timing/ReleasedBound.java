package dev.eventchain.contracts.timing;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Bounds for known phases of one clock: the releases of all tasks are followed through one
 * hyperperiod. Exact for logical execution times, where messages between them may always be on
 * their way for the longest time that is known of it; Kloda's for others.
 */
final class ReleasedBound implements PathBound {

  /** The most releases that are followed; a hyperperiod of more has no such bound. */
  private static final long MOST_RELEASES = 1_000_000;

  private final Method method;
  private final Trigger trigger;

  private ReleasedBound(Method method, Trigger trigger) {
    this.method = method;
    this.trigger = trigger;
  }

  static ReleasedBound let() {
    return new ReleasedBound(Method.LET, Trigger.LOGICAL);
  }

  static ReleasedBound kloda() {
    return new ReleasedBound(Method.KLODA, Trigger.PERIODIC);
  }

  @Override
  public Optional<Bound> of(LatencyType type, List<Segment> path) {
    if (!path.stream().allMatch(this::applies)) {
      return Optional.empty();
    }
    boolean forward = type == LatencyType.REACTION;
    long period = path.get(forward ? 0 : path.size() - 1).period();
    Optional<Long> hyperperiod = hyperperiod(path, period);
    if (hyperperiod.isEmpty()) {
      return Optional.empty();
    }
    List<Long> worst = null;
    long longest = -1;
    for (long start = 0; start < hyperperiod.get(); start += period) {
      List<Long> releases = forward ? reacting(path, start) : aging(path, start);
      long time = releases.get(path.size() - 1) - releases.get(0);
      if (time > longest) {
        longest = time;
        worst = releases;
      }
    }
    return Optional.of(bound(type, path, worst));
  }

  private boolean applies(Segment segment) {
    return segment.head().trigger() == trigger && segment.head().phase().isPresent();
  }

  /** Returns the hyperperiod; empty if it has too many releases of one period. */
  private static Optional<Long> hyperperiod(List<Segment> path, long period) {
    long common = 1;
    for (Segment segment : path) {
      long other = segment.period();
      long factor = other / divisor(common, other);
      if (common > Long.MAX_VALUE / 8 / factor) {
        return Optional.empty();
      }
      common *= factor;
    }
    boolean few = common / period <= MOST_RELEASES / path.size();
    return few ? Optional.of(common) : Optional.empty();
  }

  /** Returns the greatest common divisor. */
  private static long divisor(long one, long other) {
    return other == 0 ? one : divisor(other, one % other);
  }

  /** Returns the releases that react to an event which the first task has just missed. */
  private static List<Long> reacting(List<Segment> path, long start) {
    List<Long> releases = new ArrayList<>();
    long release = path.get(0).phase() + start;
    releases.add(release);
    for (int i = 1; i < path.size(); i++) {
      Segment reader = path.get(i);
      long ready = release + path.get(i - 1).delayBefore(reader) - reader.phase();
      release = reader.phase() - Math.floorDiv(-ready, reader.period()) * reader.period();
      releases.add(release);
    }
    return releases;
  }

  /** Returns the releases of the oldest data that a release of the last task may read. */
  private static List<Long> aging(List<Segment> path, long start) {
    int last = path.size() - 1;
    List<Long> releases = new ArrayList<>();
    long release = path.get(last).phase() + start;
    releases.add(release);
    for (int i = last - 1; i >= 0; i--) {
      Segment writer = path.get(i);
      long written = release - writer.delayBefore(path.get(i + 1)) - writer.phase();
      release = Math.floorDiv(written, writer.period()) * writer.period() + writer.phase();
      releases.add(0, release);
    }
    return releases;
  }

  private Bound bound(LatencyType type, List<Segment> path, List<Long> releases) {
    List<Long> waiting = new ArrayList<>();
    List<Long> counted = new ArrayList<>();
    waiting.add(type == LatencyType.REACTION ? path.get(0).firstWaiting() : 0);
    for (int i = 1; i < path.size(); i++) {
      long hop = releases.get(i) - releases.get(i - 1);
      long response = Math.min(path.get(i - 1).response(), hop);
      counted.add(response);
      waiting.add(hop - response);
    }
    counted.add(path.get(path.size() - 1).response());
    return PathBound.sum(method, path, waiting, counted);
  }
}

package dev.eventchain.contracts.timing;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Latency along one path, as far as it is known.
 *
 * @param bounds all that hold, the smallest first and of equal ones that with the fewest
 *     assumptions; none if a number is missing
 * @param gaps what is missing
 * @param known the sum of the waiting and response times that are known: what the bounds for any
 *     phases would be at least, in ns
 */
public record PathLatency(List<Task> path, List<Bound> bounds, List<Gap> gaps, long known) {

  private static final List<PathBound> ALL =
      List.of(
          ReleasedBound.let(), SummedBound.davare(), SummedBound.duerr(), ReleasedBound.kloda());

  /** Copies the lists. */
  public PathLatency {
    path = List.copyOf(path);
    bounds = List.copyOf(bounds);
    gaps = List.copyOf(gaps);
  }

  /** Returns the latency along a path of at least one task. */
  public static PathLatency of(LatencyType type, List<Task> path) {
    List<Segment> segments = Segment.of(path);
    List<Gap> gaps = gaps(type, segments, path);
    List<Bound> bounds = new ArrayList<>();
    if (gaps.isEmpty()) {
      ALL.forEach(each -> each.of(type, segments).ifPresent(bounds::add));
      bounds.sort(Comparator.comparingLong(Bound::time));
    }
    return new PathLatency(path, bounds, gaps, known(type, segments, path));
  }

  private static List<Gap> gaps(LatencyType type, List<Segment> segments, List<Task> path) {
    List<Gap> gaps = new ArrayList<>();
    sampling(type, segments).stream()
        .filter(task -> task.period().isEmpty())
        .forEach(task -> gaps.add(new Gap(task.name(), Gap.Kind.PERIOD)));
    path.stream()
        .filter(task -> task.response().isEmpty())
        .forEach(task -> gaps.add(new Gap(task.name(), Gap.Kind.RESPONSE)));
    return gaps;
  }

  /** Returns the tasks whose periods take part in a latency. */
  private static List<Task> sampling(LatencyType type, List<Segment> segments) {
    List<Segment> taking = segments;
    if (type == LatencyType.DATA_AGE) {
      taking = segments.subList(0, segments.size() - 1);
    } else if (segments.get(0).startsAtOnce()) {
      taking = segments.subList(1, segments.size());
    }
    return taking.stream().map(Segment::head).toList();
  }

  private static long known(LatencyType type, List<Segment> segments, List<Task> path) {
    List<Task> sampling = sampling(type, segments);
    long periods = 0;
    for (int i = 0; i < sampling.size(); i++) {
      boolean atOnce = type == LatencyType.DATA_AGE && segments.get(i + 1).mayFollowAtOnce();
      periods += atOnce ? 0 : sampling.get(i).period().orElse(0);
    }
    return periods + path.stream().mapToLong(task -> task.response().orElse(0)).sum();
  }

  /** Returns the smallest bound; empty if none is known. */
  public Optional<Bound> bound() {
    return bounds.stream().findFirst();
  }
}

package dev.eventchain.contracts.latency;

import dev.eventchain.contracts.timing.Bound;
import dev.eventchain.contracts.timing.LatencyType;
import dev.eventchain.contracts.timing.PathLatency;
import java.math.BigDecimal;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;

/**
 * Estimate of a latency by its chain. All times are in ns.
 *
 * @param outside the longest time before the first component that counts: the age of a message when
 *     it is read, as far as the latency is a data age, and what the constraint counts before its
 *     arrival, and the time on its way that the model states; what is not known of it counts as 0
 * @param paths along all paths of the data; none if nothing leads from the first to the last
 *     component, or if there are too many
 * @param unavoidable the longest latency that no phases avoid: the worst-case execution and
 *     transport times that are known, on the shortest path
 * @param placed what executes the components on these paths, and which messages are taken to be
 *     there at once, in words
 * @param unknown what is not known and would be needed for a bound, in words
 */
public record LatencyEstimate(
    LatencyType type,
    long outside,
    List<PathLatency> paths,
    long unavoidable,
    String placed,
    List<String> unknown) {

  /** Copies the lists. */
  public LatencyEstimate {
    paths = List.copyOf(paths);
    unknown = List.copyOf(unknown);
  }

  /** Returns the upper bound; empty if it is not known. */
  public OptionalLong bound() {
    return unknown.isEmpty()
        ? slowest().stream().mapToLong(path -> outside + path.time()).findFirst()
        : OptionalLong.empty();
  }

  /** Returns the bound of the path that decides; empty if one of the paths has none. */
  public Optional<Bound> slowest() {
    boolean all = paths.stream().allMatch(path -> path.bound().isPresent());
    return all
        ? paths.stream()
            .map(path -> path.bound().orElseThrow())
            .max(Comparator.comparingLong(Bound::time))
        : Optional.empty();
  }

  /** Returns what a bound for any phases is at least, from all numbers that are known. */
  public long known() {
    return outside + paths.stream().mapToLong(PathLatency::known).max().orElse(0);
  }

  /** Returns the source of a bound and what it assumes, for users. */
  public String assumption(Bound bound) {
    return bound.method().assumption() + "; " + placed;
  }

  /**
   * Returns the parts of the path that decides, in ms: {@code A 50 + 15, B 20 + 1}, and first what
   * passes before it.
   */
  public String shares() {
    String before = outside > 0 ? "before the first one " + milliseconds(outside) + ", " : "";
    return before
        + slowest().stream()
            .flatMap(bound -> bound.shares().stream())
            .map(
                it ->
                    it.task()
                        + " "
                        + milliseconds(it.waiting())
                        + " + "
                        + milliseconds(it.response()))
            .collect(Collectors.joining(", "));
  }

  /** Returns a time in ms, as short as it can be written to a microsecond. */
  public static String milliseconds(long nanoseconds) {
    BigDecimal time = BigDecimal.valueOf((nanoseconds + 999) / 1000, 3);
    return time.signum() == 0 ? "0" : time.stripTrailingZeros().toPlainString();
  }
}

package dev.eventchain.simulation.tracing;

import dev.eventchain.simulation.host.RunLog.SampleId;
import dev.eventchain.simulation.tracing.RosActivity.Publication;
import dev.eventchain.simulation.tracing.RosActivity.Take;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * The messages on the topics of a chain, and which of them was taken.
 *
 * <p>Published and taken messages are the same if they carry the same time. Releases of ROS 2 that
 * do not record it when they publish set it at most 2 ms later; it is then the last message that
 * was published before. Messages without any publisher in the trace come from outside: they count
 * as published at the time that they carry.
 */
final class TracedMessages {

  /** Rounding of the times of Fast DDS, in ns. */
  private static final long ROUNDING = 1;

  /** The longest time from the event of a publication to the time that it carries, in ns. */
  private static final long LATER = 2_000_000;

  private final Map<String, Map<Long, Long>> publications = new LinkedHashMap<>();
  private final Map<Publication, SampleId> samples = new HashMap<>();
  private final Map<String, NavigableMap<Long, SampleId>> stamped = new LinkedHashMap<>();
  private final Map<String, NavigableMap<Long, SampleId>> unstamped = new LinkedHashMap<>();
  private final Set<String> published = new HashSet<>();
  private final Map<String, Set<Long>> outside = new LinkedHashMap<>();

  /** Collects the messages on some topics. */
  TracedMessages(RosActivity activity, Set<String> topics) {
    activity.publishers.forEach(publisher -> published.add(publisher.topic()));
    for (Publication each : activity.publications) {
      String topic = each.publisher.topic();
      if (topics.contains(topic)) {
        SampleId sample = add(topic, each.time);
        samples.put(each, sample);
        Map<String, NavigableMap<Long, SampleId>> index = each.stamp == 0 ? unstamped : stamped;
        long key = each.stamp == 0 ? each.time : each.stamp;
        index.computeIfAbsent(topic, it -> new TreeMap<>()).put(key, sample);
      }
    }
  }

  private SampleId add(String topic, long time) {
    Map<Long, Long> ofTopic = publications.computeIfAbsent(topic, it -> new LinkedHashMap<>());
    SampleId sample = new SampleId(topic, ofTopic.size());
    ofTopic.put(sample.sequence(), time);
    return sample;
  }

  /** Returns a published message; empty if its topic is not one of the chain. */
  Optional<SampleId> published(Publication publication) {
    return Optional.ofNullable(samples.get(publication));
  }

  /** Returns a message that was taken; empty if it is none that was published. */
  Optional<SampleId> taken(Take take) {
    String topic = take.subscription.topic();
    if (take.stamp == 0) {
      return Optional.empty();
    }
    NavigableMap<Long, SampleId> exact = stamped.computeIfAbsent(topic, it -> new TreeMap<>());
    boolean isOutside = !published.contains(topic) && take.stamp <= take.time;
    if (isOutside && !exact.containsKey(take.stamp)) {
      exact.put(take.stamp, add(topic, take.stamp));
      outside.computeIfAbsent(topic, it -> new HashSet<>()).add(take.stamp);
    }
    return within(exact, take.stamp + ROUNDING, 2 * ROUNDING)
        .or(() -> within(unstamped.getOrDefault(topic, new TreeMap<>()), take.stamp, LATER));
  }

  private static Optional<SampleId> within(
      NavigableMap<Long, SampleId> index, long latest, long most) {
    Map.Entry<Long, SampleId> found = index.floorEntry(latest);
    return found == null || found.getKey() < latest - most
        ? Optional.empty()
        : Optional.of(found.getValue());
  }

  /** Returns the times of all messages, in ns, by topic and number. */
  Map<String, Map<Long, Long>> publications() {
    return publications;
  }

  /** Returns the longest time between two messages of a topic, in ns; empty for less than two. */
  OptionalLong interval(String topic) {
    List<Long> times =
        publications.getOrDefault(topic, Map.of()).values().stream().sorted().toList();
    return IntStream.range(1, times.size()).mapToLong(i -> times.get(i) - times.get(i - 1)).max();
  }

  /** Returns the number of messages from outside of the trace, by topic. */
  Map<String, Integer> outside() {
    Map<String, Integer> counts = new LinkedHashMap<>();
    outside.forEach((topic, times) -> counts.put(topic, times.size()));
    return counts;
  }
}

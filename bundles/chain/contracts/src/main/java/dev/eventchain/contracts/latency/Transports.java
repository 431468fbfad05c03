package dev.eventchain.contracts.latency;

import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;

/**
 * Ways of messages that take time, as a chain states it. A message is on its way as long as the
 * longest time that its two ends state for any of its fields; without one, both are on the same
 * machine, and it is there at once.
 */
final class Transports {

  private static final double MILLISECOND = 1e6;

  /** Times that are longer, some days, are as good as unknown, and sums of shorter ones exact. */
  private static final double LONGEST = 1e15;

  /**
   * Way of messages to a component.
   *
   * @param topic the one that takes longest
   * @param time in ns, rounded up; empty if what is stated is no time
   */
  record Way(String topic, OptionalLong time) {

    private static Way of(String topic, double milliseconds) {
      double time = milliseconds * MILLISECOND;
      return new Way(
          topic,
          time >= 0 && time < LONGEST
              ? OptionalLong.of((long) Math.ceil(time))
              : OptionalLong.empty());
    }

    /** Returns whether messages are stated to be there at once. */
    boolean isNone() {
      return time.equals(OptionalLong.of(0));
    }

    private boolean isLongerThan(Way other) {
      return other.time.isPresent()
          && (time.isEmpty() || time.getAsLong() > other.time.getAsLong());
    }
  }

  private final TopicIndex topics;
  private final DataFlowIndex flow;

  Transports(TopicIndex topics, DataFlowIndex flow) {
    this.topics = topics;
    this.flow = flow;
  }

  /** Returns the longest way of data between two components; empty if none is stated. */
  Optional<Way> between(SoftwareNode writer, SoftwareNode reader) {
    Set<String> connecting = new LinkedHashSet<>();
    for (Data input : reader.getInput()) {
      if (flow.producers(input).stream().anyMatch(writer.getOutput()::contains)) {
        TopicIndex.nameOf(input, reader).ifPresent(connecting::add);
      }
    }
    Optional<Way> longest = Optional.empty();
    for (String topic : connecting) {
      List<Data> ends = data(topics.find(topic).orElseThrow().publishers(), writer);
      ends.addAll(data(topics.find(topic).orElseThrow().subscribers(), reader));
      longest = longer(longest, longest(topic, ends));
    }
    return longest;
  }

  /** Returns the longest way of a topic's messages to a component; empty if none is stated. */
  Optional<Way> to(SoftwareNode reader, String topic) {
    List<Data> ends = new ArrayList<>();
    topics
        .find(topic)
        .ifPresent(
            found -> {
              found.publishers().forEach(end -> ends.addAll(end.data()));
              ends.addAll(data(found.subscribers(), reader));
            });
    return longest(topic, ends);
  }

  private static List<Data> data(List<TopicIndex.Endpoint> ends, SoftwareNode node) {
    List<Data> found = new ArrayList<>();
    ends.stream().filter(end -> end.node() == node).forEach(end -> found.addAll(end.data()));
    return found;
  }

  private static Optional<Way> longest(String topic, List<Data> data) {
    Optional<Way> longest = Optional.empty();
    for (Data each : data) {
      if (each.isSetWorstCaseTransportTime()) {
        longest = longer(longest, Optional.of(Way.of(topic, each.getWorstCaseTransportTime())));
      }
    }
    return longest;
  }

  private static Optional<Way> longer(Optional<Way> one, Optional<Way> other) {
    boolean second = one.isEmpty() || (other.isPresent() && other.get().isLongerThan(one.get()));
    return second ? other : one;
  }
}

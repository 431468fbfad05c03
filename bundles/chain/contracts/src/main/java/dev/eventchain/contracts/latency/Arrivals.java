package dev.eventchain.contracts.latency;

import dev.eventchain.contracts.timing.LatencyType;
import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;

/** Times before the first component of a latency: of messages on their way, and since they came. */
final class Arrivals {

  private static final double MILLISECOND = 1e6;

  private final TopicIndex topics;
  private final DataFlowIndex flow;
  private final Deployment deployment;
  private final Transports transports;
  private final Stimuli stimuli;

  Arrivals(
      TopicIndex topics,
      DataFlowIndex flow,
      Deployment deployment,
      Transports transports,
      Stimuli stimuli) {
    this.topics = topics;
    this.flow = flow;
    this.deployment = deployment;
    this.transports = transports;
    this.stimuli = stimuli;
  }

  /** Returns what counts before the first component, and adds what is not known of it. */
  long before(LatencyType type, LatencyConstraint constraint, Set<String> unknown) {
    long longest = 0;
    for (String topic : topics(constraint.getFirst())) {
      long time =
          stimuli.before(topic, constraint) + transport(topic, constraint.getFirst(), unknown);
      if (type == LatencyType.DATA_AGE) {
        OptionalLong interval = interval(topic, constraint.getFirst());
        if (interval.isEmpty()) {
          unknown.add("how long a message of " + topic + " stays the last one is not known");
        }
        time += interval.orElse(0);
      }
      longest = Math.max(longest, time);
    }
    return longest;
  }

  /** Returns the longest time of a message on its way to a component, as {@link #before}. */
  long transport(SoftwareNode first, Set<String> unknown) {
    return topics(first).stream()
        .mapToLong(topic -> transport(topic, first, unknown))
        .max()
        .orElse(0);
  }

  /** Returns the time of a message on its way to a component, and adds that it is not known. */
  private long transport(String topic, SoftwareNode reader, Set<String> unknown) {
    Optional<Transports.Way> way = transports.to(reader, topic);
    if (way.isPresent() && way.get().time().isEmpty()) {
      unknown.add(noTime(way.get()));
    }
    return way.map(it -> it.time().orElse(0)).orElse(0L);
  }

  /** Returns the topics of which no time on the way to a component is stated. */
  List<String> atOnce(SoftwareNode first) {
    return topics(first).stream().filter(topic -> transports.to(first, topic).isEmpty()).toList();
  }

  static String noTime(Transports.Way way) {
    return "the transport time of " + way.topic() + " is none that a bound can count";
  }

  /**
   * Returns the topics that a component reads, except for those written by components behind it.
   */
  Set<String> topics(SoftwareNode first) {
    Set<SoftwareNode> behind = flow.behind(first);
    Set<String> found = new LinkedHashSet<>();
    for (Data input : first.getInput()) {
      TopicIndex.nameOf(input, first)
          .filter(
              topic -> writers(topic).stream().noneMatch(it -> it == first || behind.contains(it)))
          .ifPresent(found::add);
    }
    return found;
  }

  private List<SoftwareNode> writers(String topic) {
    return topics.find(topic).stream()
        .flatMap(found -> found.publishers().stream())
        .map(TopicIndex.Endpoint::node)
        .toList();
  }

  /** Returns how old a message may be when a component reads it; empty if not known. */
  private OptionalLong interval(String topic, SoftwareNode reader) {
    List<SoftwareNode> writers = writers(topic);
    List<OptionalLong> intervals = new ArrayList<>();
    if (writers.isEmpty()) {
      intervals.add(stimuli.interval(topic));
    }
    for (SoftwareNode writer : writers) {
      OptionalLong period =
          NodeTimes.isComponent(writer) ? NodeTimes.period(writer) : OptionalLong.empty();
      OptionalLong response = deployment.response(writer);
      intervals.add(
          period.isPresent() && response.isPresent()
              ? OptionalLong.of(period.getAsLong() + response.getAsLong())
              : OptionalLong.empty());
    }
    return intervals.stream().allMatch(OptionalLong::isPresent)
        ? intervals.stream().mapToLong(OptionalLong::getAsLong).max()
        : maximumAge(topic, reader);
  }

  /** Returns the age from which on a component does not execute with a message. */
  private static OptionalLong maximumAge(String topic, SoftwareNode reader) {
    return reader.getInput().stream()
        .filter(input -> TopicIndex.nameOf(input, reader).filter(topic::equals).isPresent())
        .filter(input -> input.isSetMaximumAge() && input.getMaximumAge() > 0)
        .mapToLong(input -> (long) Math.ceil(input.getMaximumAge() * MILLISECOND))
        .min();
  }
}

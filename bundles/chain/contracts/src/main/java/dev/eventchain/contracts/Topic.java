package dev.eventchain.contracts;

import dev.eventchain.model.Signal;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.EventChain;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A topic with its publishers and subscribers, in chain order.
 *
 * @param name its full name
 * @param signal the description of the topic outside the chain
 */
record Topic(
    String name, List<Endpoint> publishers, List<Endpoint> subscribers, Optional<Signal> signal) {

  /**
   * Returns the topics of a chain, in the order of appearance. Data without a topic are skipped.
   */
  static List<Topic> of(EventChain chain, Map<String, Signal> signals) {
    return TopicIndex.of(chain).topics().stream()
        .map(
            topic ->
                new Topic(
                    topic.name(),
                    endpoints(topic.publishers()),
                    endpoints(topic.subscribers()),
                    Optional.ofNullable(signals.get(topic.name()))))
        .toList();
  }

  private static List<Endpoint> endpoints(List<TopicIndex.Endpoint> all) {
    return all.stream().map(found -> new Endpoint(found.node(), found.data())).toList();
  }

  /** Returns the publishers, then the subscribers. */
  List<Endpoint> endpoints() {
    return Stream.concat(publishers.stream(), subscribers.stream()).toList();
  }

  boolean is(Signal.Direction direction) {
    return signal.map(known -> known.direction() == direction).orElse(false);
  }
}

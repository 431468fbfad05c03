package dev.eventchain.contracts;

import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Finds components that never execute. A component first executes when a message of each topic that
 * it reads has come, and writes nothing before. So components in a loop wait for each other unless
 * a message comes from elsewhere. A node that is hosted as it is executes when it likes. Takes time
 * linear in the chain.
 */
final class Waiting {

  private final TopicIndex topics;
  private final Map<SoftwareNode, Integer> missing = new HashMap<>();
  private final Map<SoftwareNode, Set<TopicIndex.Topic>> written = new HashMap<>();
  private final Set<TopicIndex.Topic> arrived = new HashSet<>();
  private final Deque<SoftwareNode> ready = new ArrayDeque<>();

  private Waiting(EventChain chain) {
    topics = TopicIndex.of(chain);
    for (TopicIndex.Topic topic : topics.topics()) {
      topic.subscribers().forEach(reader -> missing.merge(reader.node(), 1, Integer::sum));
      topic
          .publishers()
          .forEach(
              writer ->
                  written.computeIfAbsent(writer.node(), key -> new LinkedHashSet<>()).add(topic));
    }
  }

  /**
   * Returns the components that wait for each other, and those that wait for them.
   *
   * @param outside holds for the full names of topics that somebody else may write, too
   */
  static Set<SoftwareNode> in(EventChain chain, Predicate<String> outside) {
    Waiting waiting = new Waiting(chain);
    for (SoftwareNode node : chain.getSoftware()) {
      if (node.getImplementation() == ComponentImplementation.NODE) {
        waiting.missing.remove(node);
      }
      if (!waiting.missing.containsKey(node)) {
        waiting.ready.add(node);
      }
    }
    for (TopicIndex.Topic topic : waiting.topics.topics()) {
      if (topic.publishers().isEmpty() || outside.test(topic.name())) {
        waiting.arrive(topic);
      }
    }
    waiting.run();
    return waiting.missing.keySet();
  }

  private void run() {
    while (!ready.isEmpty()) {
      written.getOrDefault(ready.remove(), Set.of()).forEach(this::arrive);
    }
  }

  private void arrive(TopicIndex.Topic topic) {
    if (arrived.add(topic)) {
      for (TopicIndex.Endpoint reader : topic.subscribers()) {
        Integer left = missing.computeIfPresent(reader.node(), (node, count) -> count - 1);
        if (left != null && left == 0) {
          missing.remove(reader.node());
          ready.add(reader.node());
        }
      }
    }
  }
}

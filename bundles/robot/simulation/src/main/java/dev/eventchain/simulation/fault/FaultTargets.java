package dev.eventchain.simulation.fault;

import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.bench.Bench;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * Possible targets of faults.
 *
 * @param nodes the simulated nodes
 * @param topics that the world sends or simulated nodes write
 * @param sensors topics that the world sends
 */
record FaultTargets(List<String> nodes, Set<String> topics, Set<String> sensors) {

  static FaultTargets of(EventChain chain, Bench bench) {
    List<String> nodes = new ArrayList<>();
    for (SoftwareNode node : chain.getSoftware()) {
      if (node.getImplementation() == ComponentImplementation.COMPONENT) {
        nodes.add(node.getName());
      }
    }
    Set<String> sensors = new TreeSet<>(bench.provided().keySet());
    Set<String> topics = new TreeSet<>(sensors);
    TopicIndex.of(chain).topics().stream()
        .filter(
            topic ->
                topic.publishers().stream().anyMatch(end -> nodes.contains(end.node().getName())))
        .forEach(topic -> topics.add(topic.name()));
    return new FaultTargets(nodes, topics, sensors);
  }
}

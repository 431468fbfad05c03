package dev.eventchain.simulation.measure;

import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.verdict.MessageFlow;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A topic from one of its writers to one of its readers, with the limits of the model.
 *
 * @param writer a component's name, or {@link MessageFlow#VEHICLE}
 * @param reader a component's name, or {@link MessageFlow#VEHICLE}
 * @param maximumAge maximum age of a sample that is read, in ms; empty if there is no limit
 * @param deadline the longest time between two messages, in ms; empty if none is stated
 */
record ChainHop(
    String topic,
    String writer,
    String reader,
    OptionalDouble maximumAge,
    OptionalDouble deadline) {

  /**
   * Returns all hops of the simulated components: by the reading components, in chain order, and
   * then those to the vehicle.
   */
  static List<ChainHop> of(SimulatedChain chain) {
    List<ChainHop> hops = new ArrayList<>();
    for (SoftwareNode node : chain.nodes()) {
      Map<String, Double> ages = InputAges.limits(node, chain);
      for (String topic : chain.topicsReadBy(node)) {
        OptionalDouble age =
            ages.containsKey(topic) ? OptionalDouble.of(ages.get(topic)) : OptionalDouble.empty();
        OptionalDouble requested = deadline(node.getInput(), node, topic);
        if (chain.bench().provided().containsKey(topic)) {
          hops.add(new ChainHop(topic, MessageFlow.VEHICLE, node.getName(), age, requested));
        }
        for (String writer : chain.writers(topic)) {
          OptionalDouble deadline =
              requested.isPresent() ? requested : offered(writer, topic, chain);
          hops.add(new ChainHop(topic, writer, node.getName(), age, deadline));
        }
      }
    }
    hops.addAll(toVehicle(chain));
    return hops;
  }

  private static List<ChainHop> toVehicle(SimulatedChain chain) {
    List<ChainHop> hops = new ArrayList<>();
    for (SoftwareNode node : chain.nodes()) {
      for (String topic : chain.topicsWrittenBy(node)) {
        if (chain.bench().consumed().containsKey(topic)) {
          OptionalDouble deadline = deadline(node.getOutput(), node, topic);
          OptionalDouble age = OptionalDouble.empty();
          hops.add(new ChainHop(topic, node.getName(), MessageFlow.VEHICLE, age, deadline));
        }
      }
    }
    return hops;
  }

  private static OptionalDouble offered(String writer, String topic, SimulatedChain chain) {
    Optional<SoftwareNode> node =
        chain.nodes().stream().filter(each -> each.getName().equals(writer)).findFirst();
    return node.map(each -> deadline(each.getOutput(), each, topic)).orElse(OptionalDouble.empty());
  }

  /** Returns the shortest deadline that a node states for a topic. */
  private static OptionalDouble deadline(Collection<Data> data, SoftwareNode node, String topic) {
    return data.stream()
        .filter(each -> TopicIndex.nameOf(each, node).filter(topic::equals).isPresent())
        .filter(each -> each.getQos() != null && each.getQos().getDeadline() > 0)
        .mapToDouble(each -> each.getQos().getDeadline())
        .min();
  }
}

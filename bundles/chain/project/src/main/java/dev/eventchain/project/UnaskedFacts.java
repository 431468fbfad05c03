package dev.eventchain.project;

import dev.eventchain.model.Processors;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EAttribute;

/** Facts about components that language models are not asked for. */
final class UnaskedFacts {

  private static final List<EAttribute> ATTRIBUTES =
      List.of(
          Literals.SOFTWARE_NODE__BEST_CASE_EXECUTION_TIME,
          Literals.SOFTWARE_NODE__WORST_CASE_EXECUTION_TIME,
          Literals.SOFTWARE_NODE__MEMORY,
          Literals.SOFTWARE_NODE__TOLERANCE,
          Literals.SOFTWARE_NODE__PRIORITY);

  private UnaskedFacts() {}

  /** Adds those that a component lacks from another description of it. */
  static void add(SoftwareNode node, SoftwareNode from) {
    for (EAttribute attribute : ATTRIBUTES) {
      if (!node.eIsSet(attribute) && from.eIsSet(attribute)) {
        node.eSet(attribute, from.eGet(attribute));
      }
    }
    if (node.getSynchronized().isEmpty()) {
      List<String> topics = TopicIndex.synchronizedBy(from);
      node.getInput().stream()
          .filter(it -> TopicIndex.nameOf(it, node).filter(topics::contains).isPresent())
          .forEach(node.getSynchronized()::add);
    }
    addProcessor(node, from);
    addTransport(node.getInput(), node, from.getInput(), from);
    addTransport(node.getOutput(), node, from.getOutput(), from);
    addUnits(node.getInput(), from.getInput());
    addUnits(node.getOutput(), from.getOutput());
  }

  /** Adds the transport times of topics on one side of a component. */
  private static void addTransport(
      List<Data> side, SoftwareNode node, List<Data> stated, SoftwareNode from) {
    for (Data data : side) {
      if (!data.isSetWorstCaseTransportTime()) {
        Optional<String> topic = TopicIndex.nameOf(data, node);
        stated.stream()
            .filter(Data::isSetWorstCaseTransportTime)
            .filter(it -> topic.isPresent() && topic.equals(TopicIndex.nameOf(it, from)))
            .mapToDouble(Data::getWorstCaseTransportTime)
            .max()
            .ifPresent(data::setWorstCaseTransportTime);
      }
    }
  }

  /** Adds the units of values within the component, by the names of the values. */
  private static void addUnits(List<Data> values, List<Data> from) {
    for (Data value : values) {
      from.stream()
          .filter(other -> other.getName() != null && other.getName().equals(value.getName()))
          .filter(other -> value.getComponentUnit() == null)
          .findFirst()
          .ifPresent(other -> value.setComponentUnit(other.getComponentUnit()));
    }
  }

  private static void addProcessor(SoftwareNode node, SoftwareNode from) {
    if (node.getMappedTo() == null
        && from.getMappedTo() != null
        && from.getMappedTo().getName() != null
        && node.eContainer() instanceof EventChain chain) {
      Processors.map(node, from.getMappedTo().getName(), chain);
    }
  }
}

package dev.eventchain.contracts;

import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Checks that synchronized inputs can be synchronized: at least two topics that the component
 * reads, each with a stamp in the header of its messages, and a tolerance that some stamps keep to.
 */
final class SynchronizationContracts {

  private final TypeContracts types;
  private final Findings findings;

  SynchronizationContracts(TypeContracts types, Findings findings) {
    this.types = types;
    this.findings = findings;
  }

  void check(EventChain chain) {
    chain.getSoftware().stream()
        .filter(node -> !node.getSynchronized().isEmpty() || node.isSetTolerance())
        .forEach(this::check);
  }

  private void check(SoftwareNode node) {
    findings.checked(ContractRule.SYNCHRONIZED_IMPOSSIBLE);
    List<String> topics = TopicIndex.synchronizedBy(node);
    if (topics.size() < 2) {
      findings.error(
          ContractRule.SYNCHRONIZED_IMPOSSIBLE,
          findings.at(node, Literals.SOFTWARE_NODE__SYNCHRONIZED),
          "'%s' synchronizes %s.".formatted(node.getName(), few(topics)),
          "Name the inputs of at least two topics, or neither synchronized inputs nor a tolerance.");
    }
    if (node.isSetTolerance() && !isPossible(node.getTolerance())) {
      findings.error(
          ContractRule.SYNCHRONIZED_IMPOSSIBLE,
          findings.at(node, Literals.SOFTWARE_NODE__TOLERANCE),
          "'%s' synchronizes its inputs with an impossible tolerance of %s ms."
              .formatted(node.getName(), node.getTolerance()),
          "Give a finite number above zero, or none: then stamps have to be equal.");
    }
    Set<String> seen = new HashSet<>();
    for (Data input : node.getSynchronized()) {
      checkInput(node, input);
      if (seen.add(TopicIndex.nameOf(input, node).orElse(""))) {
        checkHeader(node, input);
      }
    }
  }

  private static String few(List<String> topics) {
    return topics.isEmpty() ? "no topic, but has a tolerance" : topics.get(0) + " with nothing";
  }

  private static boolean isPossible(double tolerance) {
    return tolerance > 0 && Double.isFinite(tolerance);
  }

  private void checkInput(SoftwareNode node, Data input) {
    if (!node.getInput().contains(input)) {
      findings.error(
          ContractRule.SYNCHRONIZED_IMPOSSIBLE,
          findings.at(node, Literals.SOFTWARE_NODE__SYNCHRONIZED),
          "'%s' synchronizes '%s', which is not one of its inputs."
              .formatted(node.getName(), input.getName()),
          "Name inputs of this component: each component has data of its own.");
    }
  }

  private void checkHeader(SoftwareNode node, Data input) {
    if (types.isKnown(input)) {
      findings.checked(ContractRule.SYNCHRONIZED_HEADER);
      if (!types.isStamped(input)) {
        findings.error(
            ContractRule.SYNCHRONIZED_HEADER,
            findings.at(input, Literals.DATA__MESSAGE_TYPE),
            "'%s' synchronizes %s, but its messages have no stamp: %s has no std_msgs/msg/Header in a field 'header'."
                .formatted(node.getName(), input.getTopicName(), input.getMessageType()),
            "Use a message type with a header, or take this input by itself.",
            findings.at(node, Literals.SOFTWARE_NODE__SYNCHRONIZED));
      }
    }
  }
}

package dev.eventchain.simulation.strength;

import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.Optional;

/**
 * The requirements that the outputs of a component may serve. An output that is marked with
 * requirements serves these and no others of its component, unless nothing else of the component
 * could serve them.
 */
final class OutputPurpose {

  private final SoftwareNode node;

  OutputPurpose(SoftwareNode node) {
    this.node = node;
  }

  /** Returns whether a fault of a topic of the component can break a requirement of it. */
  boolean mayServe(String topic, String requirement) {
    return node.getOutput().stream()
            .anyMatch(data -> isOn(topic, data) && !isMarkedForOthers(data, requirement))
        || node.getOutput().stream().allMatch(data -> isMarkedForOthers(data, requirement));
  }

  private boolean isOn(String topic, Data data) {
    return TopicIndex.nameOf(data, node).equals(Optional.of(topic));
  }

  private static boolean isMarkedForOthers(Data data, String requirement) {
    return !data.getSatisfies().isEmpty()
        && data.getSatisfies().stream().map(Requirement::getId).noneMatch(requirement::equals);
  }
}

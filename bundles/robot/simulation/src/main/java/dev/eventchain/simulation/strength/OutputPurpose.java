package dev.eventchain.simulation.strength;

import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

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

  /** Returns the topics of the outputs that are marked with a requirement. */
  Stream<String> markedWith(String requirement) {
    return node.getOutput().stream()
        .filter(data -> isMarked(data, requirement))
        .flatMap(data -> TopicIndex.nameOf(data, node).stream());
  }

  /**
   * Returns the topics that serve other requirements of the component: a design that does in one
   * component what another one does in two is not tested more. None is marked with the requirement;
   * and there are none if it notices nothing of any, since nobody knows then which are its own.
   *
   * @param own the topics of which it notices faults
   * @param others those of which other ones notice some
   */
  Set<String> ofOthers(String requirement, Set<String> own, Set<String> others) {
    Set<String> found = new TreeSet<>(own.isEmpty() ? Set.of() : others);
    found.removeAll(own);
    markedWith(requirement).forEach(found::remove);
    return found;
  }

  private boolean isOn(String topic, Data data) {
    return TopicIndex.nameOf(data, node).equals(Optional.of(topic));
  }

  private static boolean isMarkedForOthers(Data data, String requirement) {
    return !data.getSatisfies().isEmpty() && !isMarked(data, requirement);
  }

  private static boolean isMarked(Data data, String requirement) {
    return data.getSatisfies().stream().map(Requirement::getId).anyMatch(requirement::equals);
  }
}

package dev.eventchain.simulation.strength;

import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The branches of the data flow between the components of a requirement. */
final class Branches {

  private final Map<SoftwareNode, Set<SoftwareNode>> behind = new LinkedHashMap<>();

  /** Creates the branches of a chain with all of its components. */
  Branches(Collection<SoftwareNode> nodes) {
    nodes.forEach(node -> behind.put(node, behind(node, nodes)));
  }

  /** Returns the components that read something which depends on a component. */
  private static Set<SoftwareNode> behind(SoftwareNode start, Collection<SoftwareNode> nodes) {
    Set<SoftwareNode> found = new HashSet<>();
    Deque<SoftwareNode> open = new ArrayDeque<>(List.of(start));
    while (!open.isEmpty()) {
      SoftwareNode node = open.remove();
      Set<String> written = topics(node, node.getOutput()).collect(Collectors.toSet());
      nodes.stream()
          .filter(other -> topics(other, other.getInput()).anyMatch(written::contains))
          .filter(found::add)
          .forEach(open::add);
    }
    return found;
  }

  private static Stream<String> topics(SoftwareNode node, Collection<Data> data) {
    return data.stream().flatMap(each -> TopicIndex.nameOf(each, node).stream());
  }

  /**
   * Returns the branches of a requirement. Each begins with the component in which it ends, and
   * goes on with those that contribute to it and to no other branch. Where outputs are marked with
   * the requirement, their components are the branches.
   *
   * @param components the components that satisfy it
   */
  List<List<String>> of(String requirement, List<SoftwareNode> components) {
    List<SoftwareNode> marked =
        components.stream().filter(it -> isMarked(it, requirement)).toList();
    if (!marked.isEmpty()) {
      return marked.stream().map(node -> List.of(node.getName())).toList();
    }
    List<SoftwareNode> ends = components.stream().filter(it -> isEnd(it, components)).toList();
    return ends.stream().map(end -> branch(end, ends, components)).toList();
  }

  private static boolean isMarked(SoftwareNode node, String requirement) {
    return new OutputPurpose(node).markedWith(requirement).findAny().isPresent();
  }

  /** Returns whether no other component is behind it; those of a cycle are all ends. */
  private boolean isEnd(SoftwareNode node, List<SoftwareNode> components) {
    return components.stream()
        .filter(behind.get(node)::contains)
        .allMatch(other -> behind.get(other).contains(node));
  }

  private List<String> branch(
      SoftwareNode end, List<SoftwareNode> ends, List<SoftwareNode> components) {
    List<String> names = new ArrayList<>(List.of(end.getName()));
    for (SoftwareNode node : components) {
      if (!ends.contains(node)
          && ends.stream().filter(behind.get(node)::contains).toList().equals(List.of(end))) {
        names.add(node.getName());
      }
    }
    return names;
  }
}

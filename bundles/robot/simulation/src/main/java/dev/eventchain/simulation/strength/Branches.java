package dev.eventchain.simulation.strength;

import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.List;

/** The branches of the data flow between the components of a requirement. */
final class Branches {

  private final DataFlowIndex flow;

  /** Creates the branches of a chain with this data flow. */
  Branches(DataFlowIndex flow) {
    this.flow = flow;
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
        .filter(flow.behind(node)::contains)
        .allMatch(other -> flow.behind(other).contains(node));
  }

  private List<String> branch(
      SoftwareNode end, List<SoftwareNode> ends, List<SoftwareNode> components) {
    List<String> names = new ArrayList<>(List.of(end.getName()));
    for (SoftwareNode node : components) {
      if (!ends.contains(node)
          && ends.stream().filter(flow.behind(node)::contains).toList().equals(List.of(end))) {
        names.add(node.getName());
      }
    }
    return names;
  }
}

package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;

/**
 * Parameters of ROS 2 that launch gives one node.
 *
 * @param values by their names, as far as they are known
 * @param unknown names of those whose values are not known, or may be replaced by others
 * @param isOpen whether there may be others
 */
record GivenParameters(Map<String, JsonNode> values, Set<String> unknown, boolean isOpen) {

  static final GivenParameters NONE = new GivenParameters(Map.of(), Set.of(), false);

  /** Parameters by their names as they are assigned one after the other; a later one wins. */
  private static final class Assigned {
    final Map<String, Optional<JsonNode>> values = new LinkedHashMap<>();
    final Set<String> unsure = new TreeSet<>();
    boolean isOpen;

    void add(ParameterAssignment each) {
      if (each.name().isEmpty()) {
        isOpen = true;
        unsure.addAll(values.keySet());
      } else {
        values.put(each.name(), each.value());
        unsure.remove(each.name());
      }
    }
  }

  /**
   * Returns the parameters of a node. As of Humble, rclpy takes those for each node first and those
   * for a node's full name then; other names with wildcards are passed over. rclcpp takes what
   * matches in the order in which its name occurs first. What they disagree about is asked.
   *
   * @param all in the order in which launch gives them; of one name, the later wins
   * @param node the full name of the node; empty if it is not known
   * @param ask receives questions
   */
  static GivenParameters of(
      List<ParameterAssignment> all, Optional<String> node, Consumer<String> ask) {
    Assigned byName = new Assigned();
    Assigned byOrder = new Assigned();
    for (String nodes : List.of(ParameterAssignment.ALL, node.orElse(""))) {
      all.stream().filter(each -> full(each.nodes()).equals(nodes)).forEach(byName::add);
    }
    Set<String> order = new LinkedHashSet<>();
    all.forEach(each -> order.add(each.nodes()));
    for (String nodes : order) {
      if (matches(nodes, node)) {
        all.stream().filter(each -> each.nodes().equals(nodes)).forEach(byOrder::add);
      }
    }
    if (node.isEmpty() && order.stream().anyMatch(each -> !each.equals(ParameterAssignment.ALL))) {
      ask.accept(
          "Which parameters has this node, whose name is not known? " + LaunchParameters.SAY);
      byOrder.add(ParameterAssignment.unknown());
    }
    return merged(byName, byOrder, ask);
  }

  private static GivenParameters merged(Assigned first, Assigned second, Consumer<String> ask) {
    Map<String, JsonNode> values = new LinkedHashMap<>();
    Set<String> unknown = new TreeSet<>(first.unsure);
    unknown.addAll(second.unsure);
    Set<String> names = new LinkedHashSet<>(second.values.keySet());
    names.addAll(first.values.keySet());
    names.remove(LaunchParameters.SIMULATED);
    for (String name : names) {
      Optional<JsonNode> one = first.values.getOrDefault(name, Optional.empty());
      Optional<JsonNode> other = second.values.getOrDefault(name, Optional.empty());
      boolean isSame = one.map(Object::toString).equals(other.map(Object::toString));
      if (isSame && one.isPresent()) {
        values.put(name, one.get());
        continue;
      }
      unknown.add(name);
      if (!isSame) {
        ask.accept(
            "What is the parameter '%s' of this node: %s or %s? Versions of ROS 2 differ in which name of a node counts. %s"
                .formatted(name, said(one), said(other), LaunchParameters.SAY));
      }
    }
    return new GivenParameters(values, unknown, first.isOpen || second.isOpen);
  }

  private static String said(Optional<JsonNode> value) {
    return value.map(JsonNode::toString).orElse("none");
  }

  private static String full(String name) {
    return name.startsWith("/") ? name : "/" + name;
  }

  private static boolean matches(String nodes, Optional<String> node) {
    return nodes.equals(ParameterAssignment.ALL)
        || node.filter(it -> matches(full(nodes).split("/"), it.split("/"))).isPresent();
  }

  /** Matches part by part, since a regular expression may take exponentially long. */
  private static boolean matches(String[] pattern, String[] name) {
    BitSet reached = new BitSet();
    reached.set(0);
    for (String part : pattern) {
      BitSet next = new BitSet();
      for (int i = reached.nextSetBit(0); i >= 0; i = reached.nextSetBit(i + 1)) {
        if (part.equals("**")) {
          next.set(i, name.length + 1);
        } else if (i < name.length && (part.equals("*") || part.equals(name[i]))) {
          next.set(i + 1);
        }
      }
      reached = next;
    }
    return reached.get(name.length);
  }

  /** Returns whether a value may differ from that of a node alone, among those of some names. */
  boolean concerns(Set<String> names) {
    return names.stream()
        .anyMatch(name -> isOpen || values.containsKey(name) || unknown.contains(name));
  }
}

package dev.eventchain.workspace.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
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
public record GivenParameters(Map<String, JsonNode> values, Set<String> unknown, boolean isOpen) {

  public static final GivenParameters NONE = new GivenParameters(Map.of(), Set.of(), false);

  /**
   * Returns the parameters of a node. As of Humble, rclpy takes those for each node first and those
   * for a node's full name then; other names with wildcards are passed over. rclcpp takes what
   * matches in the order in which its name occurs first. What they disagree about is asked.
   *
   * @param all in the order in which launch gives them; of one name, the later wins
   * @param node the full name of the node; empty if it is not known
   * @param ask receives questions
   */
  public static GivenParameters of(
      List<ParameterAssignment> all, Optional<String> node, Consumer<String> ask) {
    List<ParameterAssignment> assigned = new ArrayList<>(all);
    Set<String> order = new LinkedHashSet<>();
    all.stream().filter(each -> !each.name().isEmpty()).forEach(each -> order.add(each.nodes()));
    if (node.isEmpty() && order.stream().anyMatch(each -> !each.equals(ParameterAssignment.ALL))) {
      ask.accept(
          "Which parameters has this node, whose name is not known? " + LaunchParameters.SAY);
      assigned.add(ParameterAssignment.unknown());
    }
    Map<String, ParameterAssignment> byName = new LinkedHashMap<>();
    for (String nodes : List.of(ParameterAssignment.ALL, node.orElse(""))) {
      assigned.stream()
          .filter(each -> full(each.nodes()).equals(nodes))
          .forEach(each -> byName.put(each.name(), each));
    }
    Map<String, ParameterAssignment> byOrder = new LinkedHashMap<>();
    for (String nodes : order) {
      if (matches(nodes, node)) {
        assigned.stream()
            .filter(each -> each.nodes().equals(nodes))
            .forEach(each -> byOrder.put(each.name(), each));
      }
    }
    return merged(assigned, byName, byOrder, ask);
  }

  private static GivenParameters merged(
      List<ParameterAssignment> assigned,
      Map<String, ParameterAssignment> first,
      Map<String, ParameterAssignment> second,
      Consumer<String> ask) {
    int open = assigned.lastIndexOf(ParameterAssignment.unknown());
    Map<String, JsonNode> values = new LinkedHashMap<>();
    Set<String> unknown = new TreeSet<>();
    Set<String> names = new LinkedHashSet<>(second.keySet());
    names.addAll(first.keySet());
    names.removeAll(List.of("", LaunchParameters.SIMULATED));
    for (String name : names) {
      Optional<JsonNode> one = value(first, name);
      Optional<JsonNode> other = value(second, name);
      boolean isSame = one.map(Object::toString).equals(other.map(Object::toString));
      one.filter(it -> isSame).ifPresent(it -> values.put(name, it));
      if (!values.containsKey(name)
          || !isSure(first.get(name), assigned, open)
          || !isSure(second.get(name), assigned, open)) {
        unknown.add(name);
      }
      if (!isSame) {
        ask.accept(
            "What is the parameter '%s' of this node: %s or %s? Versions of ROS 2 differ in which name of a node counts. %s"
                .formatted(name, said(one), said(other), LaunchParameters.SAY));
      }
    }
    return new GivenParameters(values, unknown, open >= 0);
  }

  /**
   * Returns whether no file that is not known may replace a value: such a file may have a section
   * for the node, which counts more than what is given to all nodes, also behind the file.
   *
   * @param open the index of the last such file
   */
  private static boolean isSure(
      ParameterAssignment given, List<ParameterAssignment> assigned, int open) {
    int named = 0;
    while (assigned.get(named).name().isEmpty()
        || !assigned.get(named).nodes().equals(given.nodes())) {
      named++;
    }
    return open < 0 || (named > open && !given.nodes().equals(ParameterAssignment.ALL));
  }

  private static Optional<JsonNode> value(Map<String, ParameterAssignment> from, String name) {
    return Optional.ofNullable(from.get(name)).flatMap(ParameterAssignment::value);
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
  public boolean concerns(Set<String> names) {
    return names.stream()
        .anyMatch(name -> isOpen || values.containsKey(name) || unknown.contains(name));
  }
}

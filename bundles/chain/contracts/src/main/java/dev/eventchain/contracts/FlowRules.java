package dev.eventchain.contracts;

import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Rules on the data flow of a whole chain. In OCL each rule would visit all components for each
 * component. With an index, cycles take time linear in the chain; latency constraints with the same
 * first component take time linear in the components between.
 */
final class FlowRules {

  private final EventChain chain;
  private final DataFlowIndex flow;
  private final Findings findings;

  private final Optional<Map<String, Signal>> signals;

  /**
   * Creates the rules.
   *
   * @param signals the topics outside the chain, by full names; empty if unknown
   */
  FlowRules(
      EventChain chain,
      DataFlowIndex flow,
      Optional<Map<String, Signal>> signals,
      Findings findings) {
    this.chain = chain;
    this.flow = flow;
    this.signals = signals;
    this.findings = findings;
  }

  void check() {
    mainLine();
    feedback();
    latencyConstraints();
  }

  /** Checks that the main line ends; otherwise it defines no order of execution. */
  private void mainLine() {
    if (chain.getSoftware().stream().anyMatch(node -> node.getNextstep() != null)) {
      findings.checked(ContractRule.NEXTSTEP_CYCLE);
    }
    Set<SoftwareNode> done = new HashSet<>();
    for (SoftwareNode start : chain.getSoftware()) {
      List<SoftwareNode> line = new ArrayList<>();
      Set<SoftwareNode> here = new HashSet<>();
      SoftwareNode node = start;
      while (node != null && done.add(node)) {
        line.add(node);
        here.add(node);
        node = node.getNextstep();
      }
      // NextstepIsInChain reports a next step to itself.
      if (node != null && here.contains(node) && node.getNextstep() != node) {
        List<SoftwareNode> cycle = line.subList(line.indexOf(node), line.size());
        findings.error(
            ContractRule.NEXTSTEP_CYCLE,
            findings.at(cycle.get(0), Literals.SOFTWARE_NODE__NEXTSTEP),
            "The next steps form a cycle: " + path(cycle) + ".",
            "The main line of a chain must end: remove the nextstep of one of them.");
      }
    }
  }

  /**
   * Warns of feedback, which may be meant: nodes run on their own timers. It is an error where
   * components of it wait for the first message of each other.
   */
  private void feedback() {
    if (!chain.getSoftware().isEmpty()) {
      findings.checked(ContractRule.FLOW_CYCLE);
      findings.checked(ContractRule.FLOW_DEADLOCK);
    }
    if (flow.cycles().isEmpty()) {
      return;
    }
    Set<SoftwareNode> waiting =
        signals.map(known -> Waiting.in(chain, topic -> isProvided(known, topic))).orElse(Set.of());
    for (List<SoftwareNode> group : flow.cycles()) {
      List<SoftwareNode> stuck = group.stream().filter(waiting::contains).toList();
      List<SoftwareNode> loop = firstCycle(stuck);
      if (!loop.isEmpty()) {
        deadlock(loop);
        continue;
      }
      findings.warning(
          ContractRule.FLOW_CYCLE,
          findings.at(group.get(0), Literals.SOFTWARE_NODE__OUTPUT),
          "The data flow is cyclic: "
              + path(shortestCycle(group.get(0), new HashSet<>(group)))
              + ".",
          "If this is not a feedback loop that you want, look for the topic that is written further"
              + " down and read further up.");
    }
  }

  private static boolean isProvided(Map<String, Signal> signals, String topic) {
    return signals.containsKey(topic)
        && signals.get(topic).direction() == Signal.Direction.PROVIDED;
  }

  private void deadlock(List<SoftwareNode> loop) {
    String whose =
        loop.size() == 1 ? "it waits for a message of its own" : "they wait for each other";
    findings.error(
        ContractRule.FLOW_DEADLOCK,
        findings.at(loop.get(0), Literals.SOFTWARE_NODE__INPUT),
        "The data flow is cyclic, and never begins, since %s: %s.".formatted(whose, path(loop)),
        "A component executes for the first time when each of its inputs has come. Let one of them"
            + " do without the other's output, such as by a memory of its own.");
  }

  /** Returns the shortest cycle of the first component that is in one; empty if none is. */
  private List<SoftwareNode> firstCycle(List<SoftwareNode> group) {
    Set<SoftwareNode> within = new HashSet<>(group);
    return group.stream()
        .filter(node -> reach(node, within).containsKey(node))
        .findFirst()
        .map(node -> shortestCycle(node, within))
        .orElse(List.of());
  }

  /** Returns the shortest path from a component of a group back to it. */
  private List<SoftwareNode> shortestCycle(SoftwareNode start, Set<SoftwareNode> group) {
    Map<SoftwareNode, SoftwareNode> before = reach(start, group);
    List<SoftwareNode> cycle = new ArrayList<>();
    SoftwareNode node = before.get(start);
    while (node != start) {
      cycle.add(node);
      node = before.get(node);
    }
    cycle.add(start);
    Collections.reverse(cycle);
    return cycle;
  }

  /**
   * Returns the components that receive data from one, each with its predecessor, including the
   * start if it receives its own.
   */
  private Map<SoftwareNode, SoftwareNode> reach(SoftwareNode start, Set<SoftwareNode> within) {
    Map<SoftwareNode, SoftwareNode> before = new HashMap<>();
    Deque<SoftwareNode> open = new ArrayDeque<>(List.of(start));
    while (!open.isEmpty()) {
      SoftwareNode node = open.remove();
      for (SoftwareNode next : flow.successors(node)) {
        if (within.contains(next) && before.putIfAbsent(next, node) == null && next != start) {
          open.add(next);
        }
      }
    }
    return before;
  }

  private void latencyConstraints() {
    Map<SoftwareNode, List<LatencyConstraint>> byFirst = new LinkedHashMap<>();
    for (LatencyConstraint constraint : chain.getLatencyConstraints()) {
      // LatencyConstraintIsComplete reports those that lack an end.
      if (constraint.getFirst() != null && constraint.getLast() != null) {
        findings.checked(ContractRule.LATENCY_UNCONNECTED);
        byFirst.computeIfAbsent(constraint.getFirst(), none -> new ArrayList<>()).add(constraint);
      }
    }
    byFirst.forEach(this::connected);
  }

  private void connected(SoftwareNode first, List<LatencyConstraint> constraints) {
    Set<SoftwareNode> missing = new HashSet<>();
    constraints.forEach(constraint -> missing.add(constraint.getLast()));
    removeReached(first, missing);
    for (LatencyConstraint constraint : constraints) {
      if (missing.contains(constraint.getLast())) {
        unconnected(constraint);
      }
    }
  }

  /** Removes the start and its transitive successors from a set; stops when the set is empty. */
  private void removeReached(SoftwareNode start, Set<SoftwareNode> wanted) {
    Set<SoftwareNode> known = new HashSet<>(List.of(start));
    Deque<SoftwareNode> open = new ArrayDeque<>(known);
    wanted.remove(start);
    while (!open.isEmpty() && !wanted.isEmpty()) {
      for (SoftwareNode next : flow.successors(open.remove())) {
        if (known.add(next)) {
          wanted.remove(next);
          open.add(next);
        }
      }
    }
  }

  private void unconnected(LatencyConstraint constraint) {
    SoftwareNode first = constraint.getFirst();
    SoftwareNode last = constraint.getLast();
    Set<SoftwareNode> backwards = new HashSet<>(List.of(first));
    removeReached(last, backwards);
    findings.error(
        ContractRule.LATENCY_UNCONNECTED,
        findings.at(constraint, Literals.LATENCY_CONSTRAINT__FIRST),
        ("The latency constraint '%s' bounds the time from '%s' to '%s', but no data flows"
                + " between them.")
            .formatted(constraint.getName(), first.getName(), last.getName()),
        backwards.isEmpty()
            ? "Data flows the other way: swap first and last."
            : "Name two components that data flow connects.",
        findings.at(first, Literals.SOFTWARE_NODE__OUTPUT),
        findings.at(last, Literals.SOFTWARE_NODE__INPUT));
  }

  /** Returns a path as {@code A -> B -> A}. */
  private static String path(List<SoftwareNode> cycle) {
    return cycle.stream().map(SoftwareNode::getName).collect(Collectors.joining(" -> "))
        + " -> "
        + cycle.get(0).getName();
  }
}

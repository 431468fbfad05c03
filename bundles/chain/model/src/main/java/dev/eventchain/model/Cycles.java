package dev.eventchain.model;

import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;

/** Strongly connected components of a graph by Tarjan (1972), without recursion. */
final class Cycles {

  private final List<SoftwareNode> nodes;
  private final Map<SoftwareNode, List<SoftwareNode>> successors;
  private final Map<SoftwareNode, Visit> visits = new HashMap<>();
  private final Deque<Visit> open = new ArrayDeque<>();
  private final List<List<SoftwareNode>> groups = new ArrayList<>();

  /** A node that was reached: its number, and the lowest number that can be reached from it. */
  private static final class Visit {
    private final SoftwareNode node;
    private final int number;
    private final Iterator<SoftwareNode> rest;
    private int lowest;
    private boolean isOpen = true;

    private Visit(SoftwareNode node, int number, Iterator<SoftwareNode> rest) {
      this.node = node;
      this.number = number;
      this.rest = rest;
      this.lowest = number;
    }
  }

  Cycles(List<SoftwareNode> nodes, Map<SoftwareNode, List<SoftwareNode>> successors) {
    this.nodes = nodes;
    this.successors = successors;
  }

  /** Returns the groups, and the nodes in them, in the order of the nodes. */
  List<List<SoftwareNode>> find() {
    for (SoftwareNode node : nodes) {
      if (!visits.containsKey(node)) {
        search(node);
      }
    }
    Map<SoftwareNode, Integer> order = new HashMap<>();
    nodes.forEach(node -> order.put(node, order.size()));
    groups.forEach(group -> group.sort(Comparator.comparing(order::get)));
    groups.sort(Comparator.comparing(group -> order.get(group.get(0))));
    return groups.stream().map(List::copyOf).toList();
  }

  private void search(SoftwareNode start) {
    Deque<Visit> path = new ArrayDeque<>();
    path.push(enter(start));
    while (!path.isEmpty()) {
      Visit visit = path.peek();
      if (!visit.rest.hasNext()) {
        path.pop();
        close(visit);
        if (!path.isEmpty()) {
          path.peek().lowest = Math.min(path.peek().lowest, visit.lowest);
        }
        continue;
      }
      SoftwareNode next = visit.rest.next();
      Visit known = visits.get(next);
      if (known == null) {
        path.push(enter(next));
      } else if (known.isOpen) {
        visit.lowest = Math.min(visit.lowest, known.number);
      }
    }
  }

  private Visit enter(SoftwareNode node) {
    Visit visit = new Visit(node, visits.size(), successorsOf(node).iterator());
    visits.put(node, visit);
    open.push(visit);
    return visit;
  }

  private void close(Visit visit) {
    if (visit.lowest != visit.number) {
      return;
    }
    List<SoftwareNode> group = new ArrayList<>();
    Visit member;
    do {
      member = open.pop();
      member.isOpen = false;
      group.add(member.node);
    } while (member != visit);
    if (group.size() > 1 || successorsOf(visit.node).contains(visit.node)) {
      groups.add(group);
    }
  }

  private List<SoftwareNode> successorsOf(SoftwareNode node) {
    return successors.getOrDefault(node, List.of());
  }
}

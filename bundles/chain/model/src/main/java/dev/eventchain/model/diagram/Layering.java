package dev.eventchain.model.diagram;

import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.Vertex.Edge;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Assigns each box a layer below its predecessors in the flow. In a cycle, the lines against the
 * order of the chain lead upwards.
 */
final class Layering {

  /** Number of line parts above which signals only stay next to their writers or readers. */
  private static final int MOST_PASSES = 400;

  private final List<Vertex> vertices;
  private final List<Edge> edges;

  private Layering(List<Vertex> vertices, List<Edge> edges) {
    this.vertices = vertices;
    this.edges = edges;
  }

  /** Returns the layers from the top, with the parts of lines that cross them. */
  static List<List<Vertex>> of(List<Vertex> vertices, List<Edge> edges) {
    Layering layering = new Layering(vertices, edges);
    edges.forEach(layering::turnIfItClosesACycle);
    layering.assign();
    layering.place();
    return layering.layers();
  }

  private void turnIfItClosesACycle(Edge edge) {
    edge.isReversed = edge.from.rank >= edge.to.rank && leads(edge.to, edge.from);
  }

  private static boolean leads(Vertex start, Vertex target) {
    Set<Vertex> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<Vertex> open = new ArrayDeque<>(List.of(start));
    while (!open.isEmpty()) {
      Vertex vertex = open.pop();
      if (vertex == target) {
        return true;
      }
      if (seen.add(vertex)) {
        vertex.out.forEach(edge -> open.push(edge.to));
      }
    }
    return false;
  }

  /** Assigns each box the layer below its lowest predecessor. */
  private void assign() {
    IdentityHashMap<Vertex, Integer> waitsFor = new IdentityHashMap<>();
    edges.forEach(edge -> waitsFor.merge(edge.lower(), 1, Integer::sum));
    IdentityHashMap<Vertex, List<Edge>> down = new IdentityHashMap<>();
    edges.forEach(edge -> down.computeIfAbsent(edge.upper(), v -> new ArrayList<>()).add(edge));
    Deque<Vertex> ready = new ArrayDeque<>();
    vertices.stream().filter(vertex -> !waitsFor.containsKey(vertex)).forEach(ready::add);
    while (!ready.isEmpty()) {
      Vertex vertex = ready.remove();
      for (Edge edge : down.getOrDefault(vertex, List.of())) {
        Vertex lower = edge.lower();
        lower.layer = Math.max(lower.layer, vertex.layer + 1);
        if (waitsFor.merge(lower, -1, Integer::sum) == 0) {
          ready.add(lower);
        }
      }
    }
  }

  /** Places external inputs at the top and outputs at the bottom, if the diagram stays clear. */
  private void place() {
    int last = vertices.stream().mapToInt(vertex -> vertex.layer).max().orElse(0);
    List<Vertex> leaving =
        vertices.stream().filter(vertex -> vertex.kind == Kind.SIGNAL_OUT).toList();
    int passes = leaving.stream().mapToInt(v -> (last - v.layer) * v.in.size()).sum();
    if (passes + edges.stream().mapToInt(Layering::passes).sum() <= MOST_PASSES) {
      leaving.forEach(vertex -> vertex.layer = last);
      return;
    }
    for (Vertex vertex : vertices) {
      if (edges(vertex, false).isEmpty()) {
        edges(vertex, true).stream()
            .mapToInt(edge -> edge.lower().layer - 1)
            .min()
            .ifPresent(layer -> vertex.layer = layer);
      }
    }
  }

  private static List<Edge> edges(Vertex vertex, boolean down) {
    List<Edge> all = new ArrayList<>(vertex.in);
    all.addAll(vertex.out);
    all.removeIf(edge -> (down ? edge.upper() : edge.lower()) != vertex);
    return all;
  }

  private static int passes(Edge edge) {
    return edge.lower().layer - edge.upper().layer - 1;
  }

  private List<List<Vertex>> layers() {
    Map<Integer, List<Vertex>> byLayer = new HashMap<>();
    List<List<Vertex>> layers = new ArrayList<>();
    vertices.forEach(v -> byLayer.computeIfAbsent(v.layer, key -> new ArrayList<>()).add(v));
    int last = vertices.stream().mapToInt(vertex -> vertex.layer).max().orElse(-1);
    for (int i = 0; i <= last; i++) {
      layers.add(byLayer.getOrDefault(i, new ArrayList<>()));
    }
    edges.forEach(edge -> cut(edge, layers));
    return layers;
  }

  private static void cut(Edge edge, List<List<Vertex>> layers) {
    Vertex above = edge.upper();
    for (int layer = above.layer + 1; layer < edge.lower().layer; layer++) {
      Vertex pass = new Vertex(null, "", 0);
      pass.layer = layer;
      layers.get(layer).add(pass);
      edge.passes.add(pass);
      above.below.add(pass);
      pass.above.add(above);
      above = pass;
    }
    above.below.add(edge.lower());
    edge.lower().above.add(above);
  }
}

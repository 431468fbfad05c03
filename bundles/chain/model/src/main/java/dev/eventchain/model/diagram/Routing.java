package dev.eventchain.model.diagram;

import dev.eventchain.model.diagram.ChainDiagram.Area;
import dev.eventchain.model.diagram.ChainDiagram.Line;
import dev.eventchain.model.diagram.ChainDiagram.Point;
import dev.eventchain.model.diagram.Vertex.Edge;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;

/**
 * Routes lines from the bottom of a box to the top of another. They may bend between layers; next
 * to boxes they are vertical, so that none crosses a box.
 */
final class Routing {

  static final int BAR = 4;

  /** Distance between a bar and its box. */
  static final int STEM = 8;

  /** Space for each line at the side of a box. */
  static final int PORT = 12;

  /** Largest offset of a line that is drawn straight instead of bent. */
  private static final int CROOKED = 3;

  private final List<int[]> bands;
  private final IdentityHashMap<Edge, Integer> lowerPorts = new IdentityHashMap<>();
  private final IdentityHashMap<Edge, Integer> upperPorts = new IdentityHashMap<>();

  /**
   * Creates a router for placed boxes.
   *
   * @param bands the first and the last y of each layer
   */
  Routing(List<Vertex> vertices, List<int[]> bands) {
    this.bands = bands;
    for (Vertex vertex : vertices) {
      assign(vertex, true);
      assign(vertex, false);
    }
  }

  /** Distributes the lines over a side, in their order; upward lines are at the right. */
  private void assign(Vertex vertex, boolean lowerSide) {
    List<Edge> forward = new ArrayList<>();
    List<Edge> back = new ArrayList<>();
    (lowerSide ? vertex.out : vertex.in).stream().filter(e -> !e.isReversed).forEach(forward::add);
    (lowerSide ? vertex.in : vertex.out).stream().filter(e -> e.isReversed).forEach(back::add);
    IdentityHashMap<Edge, Integer> ports = lowerSide ? upperPorts : lowerPorts;
    Comparator<Edge> byTarget = Comparator.comparingDouble(edge -> next(edge, lowerSide).x);
    forward.sort(byTarget);
    back.sort(byTarget);
    double right = vertex.left() + vertex.width;
    double room = back.isEmpty() ? vertex.width : vertex.width - (back.size() + 0.5) * PORT;
    spread(forward, vertex.left(), vertex.left() + room, ports);
    spread(back, forward.isEmpty() ? vertex.left() : vertex.left() + room, right, ports);
  }

  private static Vertex next(Edge edge, boolean down) {
    if (edge.passes.isEmpty()) {
      return down ? edge.lower() : edge.upper();
    }
    return edge.passes.get(down ? 0 : edge.passes.size() - 1);
  }

  private static void spread(
      List<Edge> edges, double left, double right, IdentityHashMap<Edge, Integer> ports) {
    double step = Math.min((right - left) / (edges.size() + 1), 3.0 * PORT);
    double first = (left + right) / 2 - step * (edges.size() - 1) / 2;
    for (int i = 0; i < edges.size(); i++) {
      ports.put(edges.get(i), (int) Math.round(first + i * step));
    }
  }

  /** Returns the bars of a box, which span the lines that meet there. */
  List<Area> bars(Vertex vertex) {
    List<Area> bars = new ArrayList<>();
    if (vertex.hasJoin()) {
      bars.add(bar(vertex.in, lowerPorts, vertex.y - STEM - BAR));
    }
    if (vertex.hasFork()) {
      bars.add(bar(vertex.out, upperPorts, vertex.y + vertex.height + STEM));
    }
    return bars;
  }

  private static Area bar(List<Edge> edges, IdentityHashMap<Edge, Integer> ports, int y) {
    int[] xs = edges.stream().filter(e -> !e.isReversed).mapToInt(ports::get).sorted().toArray();
    int left = xs[0] - PORT / 2;
    return new Area(left, y, xs[xs.length - 1] + PORT / 2 - left, BAR);
  }

  Line line(Edge edge, int from, int to) {
    Vertex upper = edge.upper();
    Vertex lower = edge.lower();
    List<Point> points = new ArrayList<>();
    int start = upperPorts.get(edge);
    int end = lowerPorts.get(edge);
    if (edge.passes.isEmpty() && Math.abs(start - end) <= CROOKED) {
      start = end;
    }
    boolean fork = upper.hasFork() && !edge.isReversed;
    boolean join = lower.hasJoin() && !edge.isReversed;
    add(points, start, upper.y + upper.height + (fork ? STEM + BAR : 0));
    add(points, start, bands.get(upper.layer)[1]);
    for (Vertex pass : edge.passes) {
      add(points, (int) pass.x, bands.get(pass.layer)[0]);
      add(points, (int) pass.x, bands.get(pass.layer)[1]);
    }
    add(points, end, bands.get(lower.layer)[0]);
    add(points, end, lower.y - (join ? STEM + BAR : 0));
    if (edge.isReversed) {
      Collections.reverse(points);
    }
    return new Line(from, to, edge.kind, edge.isReversed, List.copyOf(points));
  }

  /** Adds a point; merges collinear vertical segments. */
  private static void add(List<Point> points, int x, int y) {
    int size = points.size();
    if (size > 1 && points.get(size - 1).x() == x && points.get(size - 2).x() == x) {
      points.remove(size - 1);
    }
    Point point = new Point(x, y);
    if (points.isEmpty() || !points.get(points.size() - 1).equals(point)) {
      points.add(point);
    }
  }
}

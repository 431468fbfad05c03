package dev.eventchain.roads.geometry;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.function.ToDoubleFunction;

/**
 * Boxes in the plane, packed into a tree by sorting into tiles (Leutenegger et al., STR: a simple
 * and efficient algorithm for R-tree packing, 1997). Immutable.
 *
 * @param <T> what the boxes hold
 */
public final class BoxTree<T> {

  private static final int CHILDREN = 8;

  private final Node<T> root;

  /** An axis-parallel box, in m. */
  public record Box(double minX, double minY, double maxX, double maxY) {

    double distance(double x, double y) {
      double dx = Math.max(0, Math.max(minX - x, x - maxX));
      double dy = Math.max(0, Math.max(minY - y, y - maxY));
      return StrictMath.hypot(dx, dy);
    }

    Box with(Box other) {
      return new Box(
          Math.min(minX, other.minX),
          Math.min(minY, other.minY),
          Math.max(maxX, other.maxX),
          Math.max(maxY, other.maxY));
    }
  }

  /** Something with its box. */
  public record Entry<T>(Box box, T value) {}

  private record Node<T>(Box box, List<Node<T>> children, Entry<T> entry) {}

  private record Queued<T>(double distance, Node<T> node) {}

  /** Creates a tree. */
  public BoxTree(List<Entry<T>> entries) {
    List<Node<T>> level = new ArrayList<>();
    entries.forEach(entry -> level.add(new Node<>(entry.box(), List.of(), entry)));
    List<Node<T>> nodes = level;
    while (nodes.size() > 1) {
      nodes = parents(nodes);
    }
    this.root = nodes.isEmpty() ? null : nodes.get(0);
  }

  private static <T> List<Node<T>> parents(List<Node<T>> nodes) {
    List<Node<T>> byX = new ArrayList<>(nodes);
    byX.sort(Comparator.comparingDouble(node -> node.box.minX + node.box.maxX));
    int tiles = (nodes.size() + CHILDREN - 1) / CHILDREN;
    int slice = (int) Math.ceil(Math.sqrt(tiles)) * CHILDREN;
    List<Node<T>> parents = new ArrayList<>(tiles);
    for (int i = 0; i < byX.size(); i += slice) {
      List<Node<T>> column = byX.subList(i, Math.min(byX.size(), i + slice));
      column.sort(Comparator.comparingDouble(node -> node.box.minY + node.box.maxY));
      for (int j = 0; j < column.size(); j += CHILDREN) {
        List<Node<T>> of = List.copyOf(column.subList(j, Math.min(column.size(), j + CHILDREN)));
        Box box = of.stream().map(Node::box).reduce(Box::with).orElseThrow();
        parents.add(new Node<>(box, of, null));
      }
    }
    return parents;
  }

  /**
   * Visits what may be nearest to a place, nearest boxes first, until no box is as near as the best
   * distance so far.
   *
   * @param visitor returns the best distance so far, which must not be less than that of the box
   */
  public void visit(double x, double y, ToDoubleFunction<T> visitor) {
    PriorityQueue<Queued<T>> queue =
        new PriorityQueue<>(Comparator.comparingDouble((Queued<T> queued) -> queued.distance()));
    if (root != null) {
      queue.add(new Queued<>(root.box.distance(x, y), root));
    }
    double best = Double.POSITIVE_INFINITY;
    while (!queue.isEmpty() && queue.peek().distance <= best) {
      Node<T> node = queue.remove().node;
      if (node.entry != null) {
        best = visitor.applyAsDouble(node.entry.value());
      }
      for (Node<T> child : node.children) {
        queue.add(new Queued<>(child.box.distance(x, y), child));
      }
    }
  }
}

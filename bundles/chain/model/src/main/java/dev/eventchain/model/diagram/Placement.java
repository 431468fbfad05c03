package dev.eventchain.model.diagram;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/**
 * Places the boxes of each layer as near to their neighbours as order and gaps allow: constrained
 * least squares by pooling adjacent violators.
 */
final class Placement {

  private static final int GAP = 28;
  private static final int GAP_OF_LINES = 16;
  private static final int SWEEPS = 16;

  /** Weight of line parts, so that long lines become straight first. */
  private static final double BETWEEN_PASSES = 8;

  private static final double TO_A_PASS = 2;

  private Placement() {}

  /** Sets the centre of each vertex, with the leftmost box at 0. */
  static void place(List<List<Vertex>> layers) {
    for (List<Vertex> layer : layers) {
      double x = 0;
      for (int i = 0; i < layer.size(); i++) {
        x += i == 0 ? 0 : gap(layer.get(i - 1), layer.get(i));
        layer.get(i).x = x;
      }
    }
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      for (int i = 0; i < layers.size(); i++) {
        boolean down = sweep % 2 == 0;
        boolean last = sweep == SWEEPS - 1;
        settle(layers.get(down ? i : layers.size() - 1 - i), down || last, !down || last);
      }
    }
    double left =
        layers.stream().flatMap(List::stream).mapToDouble(v -> v.x - v.width / 2.0).min().orElse(0);
    layers.forEach(layer -> layer.forEach(vertex -> vertex.x = Math.rint(vertex.x - left)));
  }

  private static double gap(Vertex left, Vertex right) {
    int between = left.isPass() || right.isPass() ? GAP_OF_LINES : GAP;
    // Centres are rounded in the end.
    return Math.ceil((left.width + right.width) / 2.0) + between;
  }

  /** A block of adjacent boxes that would overlap and therefore move together. */
  private static final class Pool {
    private double weight;
    private double wanted;
    private int size = 1;

    private Pool(double weight, double wanted) {
      this.weight = weight;
      this.wanted = wanted;
    }

    private void add(Pool other) {
      wanted = (wanted * weight + other.wanted * other.weight) / (weight + other.weight);
      weight += other.weight;
      size += other.size;
    }
  }

  private static void settle(List<Vertex> layer, boolean byUpper, boolean byLower) {
    Deque<Pool> pools = new ArrayDeque<>();
    double offset = 0;
    for (int i = 0; i < layer.size(); i++) {
      offset += i == 0 ? 0 : gap(layer.get(i - 1), layer.get(i));
      Pool pool = wish(layer.get(i), byUpper, byLower);
      pool.wanted -= offset;
      while (!pools.isEmpty() && pools.getLast().wanted >= pool.wanted) {
        Pool before = pools.removeLast();
        before.add(pool);
        pool = before;
      }
      pools.add(pool);
    }
    int index = 0;
    offset = 0;
    for (Pool pool : pools) {
      for (int end = index + pool.size; index < end; index++) {
        offset += index == 0 ? 0 : gap(layer.get(index - 1), layer.get(index));
        layer.get(index).x = pool.wanted + offset;
      }
    }
  }

  private static Pool wish(Vertex vertex, boolean byUpper, boolean byLower) {
    double weight = 1e-6; // stays in place without a pull
    double sum = vertex.x * weight;
    for (List<Vertex> side : List.of(vertex.above, vertex.below)) {
      if (side == vertex.above ? byUpper : byLower) {
        for (Vertex other : side) {
          double pull = pull(vertex, other);
          weight += pull;
          sum += other.x * pull;
        }
      }
    }
    return new Pool(weight, sum / weight);
  }

  private static double pull(Vertex vertex, Vertex other) {
    if (vertex.isPass() && other.isPass()) {
      return BETWEEN_PASSES;
    }
    return vertex.isPass() || other.isPass() ? TO_A_PASS : 1;
  }
}

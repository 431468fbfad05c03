package dev.eventchain.model.diagram;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Orders the boxes of each layer for few line crossings: each at the mean position of its
 * neighbours, layer by layer down and up, after Sugiyama, Tagawa and Toda (1981).
 */
final class Ordering {

  private static final int SWEEPS = 12;

  /** Number of boxes and line parts above which fewer passes are tried. */
  private static final int LARGE = 20_000;

  private final List<List<Vertex>> layers;

  private Ordering(List<List<Vertex>> layers) {
    this.layers = layers;
  }

  static void improve(List<List<Vertex>> layers) {
    new Ordering(layers).improve();
  }

  private void improve() {
    layers.forEach(Ordering::number);
    int size = layers.stream().mapToInt(List::size).sum();
    long fewest = crossings();
    List<List<Vertex>> best = copy();
    for (int sweep = 0; fewest > 0 && sweep < (size > LARGE ? 2 : SWEEPS); sweep++) {
      sweep(sweep % 2 == 0);
      long now = crossings();
      if (now < fewest) {
        fewest = now;
        best = copy();
      }
    }
    for (int i = 0; i < layers.size(); i++) {
      layers.get(i).clear();
      layers.get(i).addAll(best.get(i));
      number(layers.get(i));
    }
  }

  private List<List<Vertex>> copy() {
    List<List<Vertex>> copy = new ArrayList<>();
    layers.forEach(layer -> copy.add(List.copyOf(layer)));
    return copy;
  }

  private static void number(List<Vertex> layer) {
    for (int i = 0; i < layer.size(); i++) {
      layer.get(i).position = i;
      layer.get(i).x = i; // mean position of the neighbours while layers are sorted
    }
  }

  private void sweep(boolean down) {
    for (int i = 1; i < layers.size(); i++) {
      List<Vertex> layer = layers.get(down ? i : layers.size() - 1 - i);
      for (Vertex vertex : layer) {
        vertex.x =
            (down ? vertex.above : vertex.below)
                .stream().mapToInt(other -> other.position).average().orElse(vertex.position);
      }
      layer.sort(Comparator.comparingDouble(vertex -> vertex.x));
      number(layer);
    }
  }

  private long crossings() {
    long count = 0;
    for (int i = 1; i < layers.size(); i++) {
      count += crossings(layers.get(i - 1), layers.get(i).size());
    }
    return count;
  }

  /** Returns the number of line crossings between two layers. */
  private static long crossings(List<Vertex> upper, int size) {
    long count = 0;
    int seen = 0;
    int[] tree =
        new int[size + 1]; // number of lines that end up to a position, after Fenwick (1994)
    for (Vertex vertex : upper) {
      int[] ends = vertex.below.stream().mapToInt(other -> other.position).toArray();
      Arrays.sort(ends);
      for (int end : ends) {
        count += seen;
        for (int i = end + 1; i > 0; i -= i & -i) {
          count -= tree[i];
        }
      }
      for (int end : ends) {
        for (int i = end + 1; i <= size; i += i & -i) {
          tree[i]++;
        }
      }
      seen += ends.length;
    }
    return count;
  }
}

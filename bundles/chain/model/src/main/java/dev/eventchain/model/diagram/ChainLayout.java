package dev.eventchain.model.diagram;

import dev.eventchain.model.diagram.ChainDiagram.Area;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.ChainDiagram.Line;
import dev.eventchain.model.diagram.ChainDiagram.Text;
import dev.eventchain.model.eventchain.EventChain;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;

/**
 * Lays out an event chain from top to bottom, like its activity diagram: components with the topics
 * between them, external signals at the top and bottom, bars where the flow forks and joins. Lines
 * lead downwards except in cycles.
 */
public final class ChainLayout {

  /** Margin around the diagram. */
  static final int MARGIN = 16;

  /** Gap between layers. */
  private static final int LAYER_GAP = 34;

  private static final int PADDING_X = 14;
  private static final int PADDING_Y = 7;

  /** Width of the slanted sides of signals. */
  private static final int SLANT = 12;

  private static final int LEAST_WIDTH = 64;
  private static final int MOST_TEXT = 300;

  private final TextSizes sizes;
  private final List<Vertex> connected;
  private final List<Vertex> loose;
  private final ChainGraph graph;

  private ChainLayout(EventChain chain, TextSizes sizes) {
    this.sizes = sizes;
    graph = new ChainGraph(chain);
    connected = new ArrayList<>(graph.vertices);
    connected.removeIf(vertex -> vertex.in.isEmpty() && vertex.out.isEmpty());
    loose = new ArrayList<>(graph.vertices);
    loose.removeIf(vertex -> !vertex.in.isEmpty() || !vertex.out.isEmpty());
  }

  /**
   * Returns the diagram of a chain.
   *
   * @param sizes measures the texts
   */
  public static ChainDiagram of(EventChain chain, TextSizes sizes) {
    ChainLayout layout = new ChainLayout(chain, sizes);
    return layout.diagram(chain.getName() == null ? "" : chain.getName());
  }

  private ChainDiagram diagram(String name) {
    List<List<Vertex>> layers = Layering.of(connected, graph.edges);
    graph.vertices.forEach(this::size);
    Ordering.improve(layers);
    Placement.place(layers);
    graph.vertices.forEach(vertex -> vertex.x += MARGIN);
    connected.stream()
        .flatMap(vertex -> vertex.out.stream())
        .flatMap(edge -> edge.passes.stream())
        .forEach(pass -> pass.x += MARGIN);
    List<int[]> bands = bands(layers);
    placeLoose(bands.isEmpty() ? MARGIN : bands.get(bands.size() - 1)[1] + LAYER_GAP);
    return collect(name, new Routing(connected, bands));
  }

  private void size(Vertex vertex) {
    TextFit fit = new TextFit(sizes);
    String title = vertex.name.isEmpty() ? "(no name)" : vertex.name;
    List<Text> texts = new ArrayList<>();
    texts.add(fit.fit(title, vertex.kind == Kind.COMPONENT, MOST_TEXT));
    if (!vertex.facts.isEmpty()) {
      texts.add(fit.fit(vertex.facts, false, MOST_TEXT));
    }
    vertex.texts = List.copyOf(texts);
    boolean slanted = vertex.kind == Kind.SIGNAL_IN || vertex.kind == Kind.SIGNAL_OUT;
    int text = texts.stream().mapToInt(Text::width).max().orElse(0);
    int lines = Math.max(vertex.in.size() + vertex.out.size(), 1) + 1;
    vertex.width =
        Math.max(
            Math.max(LEAST_WIDTH, lines * Routing.PORT),
            text + 2 * (PADDING_X + (slanted ? SLANT : 0)));
    vertex.width += vertex.width % 2; // a box of odd height has no centre for its line
    vertex.height =
        texts.stream().mapToInt(line -> sizes.height(line.title())).sum() + 2 * PADDING_Y;
  }

  /** Returns the height of each layer: that of its tallest box, including bars. */
  private static List<int[]> bands(List<List<Vertex>> layers) {
    List<int[]> bands = new ArrayList<>();
    int y = MARGIN;
    for (List<Vertex> layer : layers) {
      int above = 0;
      int height = 0;
      int below = 0;
      for (Vertex vertex : layer) {
        above = Math.max(above, vertex.hasJoin() ? Routing.STEM + Routing.BAR : 0);
        height = Math.max(height, vertex.height);
        below = Math.max(below, vertex.hasFork() ? Routing.STEM + Routing.BAR : 0);
      }
      for (Vertex vertex : layer) {
        vertex.y = y + above + (height - vertex.height) / 2;
      }
      int end = y + above + height + below;
      bands.add(new int[] {y, end});
      y = end + LAYER_GAP;
    }
    return bands;
  }

  /** Places the unconnected boxes below the rest, in an area about as wide as high. */
  private void placeLoose(int top) {
    int columns = (int) Math.ceil(Math.sqrt(loose.size()));
    int y = top;
    for (int row = 0; row * columns < loose.size(); row++) {
      int left = MARGIN;
      int height = 0;
      int end = Math.min(loose.size(), (row + 1) * columns);
      for (Vertex vertex : loose.subList(row * columns, end)) {
        vertex.x = left + Math.ceil(vertex.width / 2.0);
        vertex.y = y;
        left += vertex.width + LAYER_GAP;
        height = Math.max(height, vertex.height);
      }
      y += height + LAYER_GAP;
    }
  }

  private ChainDiagram collect(String name, Routing routing) {
    IdentityHashMap<Vertex, Integer> indices = new IdentityHashMap<>();
    List<Box> boxes = new ArrayList<>();
    for (Vertex vertex : graph.vertices) {
      indices.put(vertex, boxes.size());
      boxes.add(box(vertex, routing));
    }
    List<Line> lines = new ArrayList<>();
    graph.edges.forEach(
        edge -> lines.add(routing.line(edge, indices.get(edge.from), indices.get(edge.to))));
    int right = 0;
    int bottom = 0;
    for (Box box : boxes) {
      right = Math.max(right, box.area().x() + box.area().width());
      bottom = Math.max(bottom, box.area().y() + box.area().height());
    }
    for (Line line : lines) {
      right = Math.max(right, line.points().stream().mapToInt(p -> p.x()).max().orElse(0));
    }
    return new ChainDiagram(
        name, List.copyOf(boxes), List.copyOf(lines), right + MARGIN, bottom + MARGIN);
  }

  private static Box box(Vertex vertex, Routing routing) {
    return new Box(
        vertex.kind,
        List.copyOf(vertex.elements),
        vertex.name,
        vertex.facts,
        vertex.texts,
        new Area(vertex.left(), vertex.y, vertex.width, vertex.height),
        routing.bars(vertex),
        vertex.isGenerated);
  }
}

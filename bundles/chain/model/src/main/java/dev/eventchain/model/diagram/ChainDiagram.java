package dev.eventchain.model.diagram;

import java.util.List;
import org.eclipse.emf.ecore.EObject;

/**
 * An event chain as a picture. All lengths are pixels at 100 %, from the upper left corner.
 *
 * @param name the name of the chain; empty if it has none
 * @param boxes components and topics, no two of which overlap
 * @param lines the flow between them
 */
public record ChainDiagram(String name, List<Box> boxes, List<Line> lines, int width, int height) {

  /** The kinds of boxes. */
  public enum Kind {
    /** A software component. */
    COMPONENT,
    /** A topic that components of the chain write and read. */
    TOPIC,
    /** A topic from outside that no component writes. */
    SIGNAL_IN,
    /** A topic to outside: no component reads it, or the model declares other readers. */
    SIGNAL_OUT
  }

  /** A point. */
  public record Point(int x, int y) {}

  /** A rectangle. */
  public record Area(int x, int y, int width, int height) {

    /** Returns whether a point is inside the box or at most the given distance away. */
    public boolean isNear(int px, int py, int distance) {
      return px >= x - distance
          && py >= y - distance
          && px < x + width + distance
          && py < y + height + distance;
    }

    /** Returns the centre. */
    public Point center() {
      return new Point(x + width / 2, y + height / 2);
    }
  }

  /** A line of text in a box, cut so that it fits. */
  public record Text(String text, int width, boolean title) {}

  /**
   * A component or a topic.
   *
   * @param elements the component, or the data that are on the topic, the writer's first; at least
   *     one
   * @param name the unabbreviated name of the component, which may be empty, or of the topic
   * @param facts further properties, as readable text
   * @param texts the lines of text in the box, from the top
   * @param bars the bars where its flow joins above it and forks below it; none, one or both
   * @param generated true if it is a generated component
   */
  public record Box(
      Kind kind,
      List<EObject> elements,
      String name,
      String facts,
      List<Text> texts,
      Area area,
      List<Area> bars,
      boolean generated) {

    /** Returns the element that a click on the box selects. */
    public EObject element() {
      return elements.get(0);
    }
  }

  /** The kinds of lines. */
  public enum LineKind {
    /** Data flow. */
    FLOW,
    /** A next step of the model that no topic leads to. */
    NEXT_STEP
  }

  /**
   * A line with an arrow at its end.
   *
   * @param from the index of the box that it leaves
   * @param to the index of the box that it enters
   * @param isBack true if it leads upwards, against the order of the chain
   * @param points at least two; each segment is vertical or bends once
   */
  public record Line(int from, int to, LineKind kind, boolean isBack, List<Point> points) {}
}

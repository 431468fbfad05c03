package dev.eventchain.eclipse.diagram;

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

  /** What a box stands for. */
  public enum Kind {
    /** A software component. */
    COMPONENT,
    /** A topic that components of the chain write and read. */
    TOPIC,
    /** A topic that comes from outside: no component writes it. */
    SIGNAL_IN,
    /** A topic that leads outside: no component reads it, or the model says that others do. */
    SIGNAL_OUT
  }

  /** A place. */
  public record Point(int x, int y) {}

  /** A rectangle. */
  public record Area(int x, int y, int width, int height) {

    /** Whether a place is inside, or at most so far away. */
    public boolean isNear(int px, int py, int distance) {
      return px >= x - distance
          && py >= y - distance
          && px < x + width + distance
          && py < y + height + distance;
    }

    /** The place in the middle. */
    public Point center() {
      return new Point(x + width / 2, y + height / 2);
    }
  }

  /** A line of text in a box, cut so that it fits. */
  public record Text(String text, int width, boolean title) {}

  /**
   * A component or a topic.
   *
   * @param elements the component, or the data that are on the topic, with what writes it first; at
   *     least one
   * @param name the whole name: of the component, which may be empty, or of the topic
   * @param facts what else it says, as a person reads it
   * @param texts what is written in it, from the top
   * @param bars where its flow joins above it and forks below it; none, one or both
   * @param generated whether it is a component that was generated
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

    /** What a click on the box selects. */
    public EObject element() {
      return elements.get(0);
    }
  }

  /** What a line stands for. */
  public enum LineKind {
    /** Data. */
    FLOW,
    /** The model names a next step, but no topic leads there. */
    NEXT_STEP
  }

  /**
   * A line with an arrow at its end.
   *
   * @param from the index of the box that it leaves
   * @param to the index of the box that it enters
   * @param isBack whether it leads upwards, against the order of the chain
   * @param points at least two; between two of them it goes straight down or bends once
   */
  public record Line(int from, int to, LineKind kind, boolean isBack, List<Point> points) {}
}

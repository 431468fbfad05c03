package dev.eventchain.model.diagram;

import dev.eventchain.model.diagram.ChainDiagram.Area;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.ChainDiagram.Line;
import dev.eventchain.model.diagram.ChainDiagram.Point;
import dev.eventchain.model.diagram.ChainDiagram.Text;
import java.util.ArrayList;
import java.util.List;

/** The shapes of boxes, for all renderers. */
public final class Shapes {

  /** Width by which the sides of a signal point in or out. */
  private static final int SLANT = 10;

  private Shapes() {}

  /** A line between a box and its bar, from the upper to the lower end. */
  public record Stem(int x, int from, int to) {}

  /** A text and its upper left corner. */
  public record PlacedText(Text text, int x, int y) {}

  /**
   * Returns the corners of a box. Signals have UML shapes: a sent one has a point on the right, a
   * received one a notch on the left.
   */
  public static List<Point> outline(Box box) {
    Area area = box.area();
    int right = area.x() + area.width();
    int bottom = area.y() + area.height();
    int middle = area.center().y();
    List<Point> corners = new ArrayList<>();
    boolean isSent = box.kind() == Kind.SIGNAL_OUT;
    corners.add(new Point(area.x(), area.y()));
    corners.add(new Point(isSent ? right - SLANT : right, area.y()));
    if (isSent) {
      corners.add(new Point(right, middle));
    }
    corners.add(new Point(isSent ? right - SLANT : right, bottom));
    corners.add(new Point(area.x(), bottom));
    if (box.kind() == Kind.SIGNAL_IN) {
      corners.add(new Point(area.x() + SLANT, middle));
    }
    return corners;
  }

  /** Returns the lines between a box and its bars. */
  public static List<Stem> stems(Box box) {
    Area area = box.area();
    List<Stem> stems = new ArrayList<>();
    for (Area bar : box.bars()) {
      boolean isAbove = bar.y() < area.y();
      stems.add(
          new Stem(
              bar.center().x(),
              isAbove ? bar.y() + bar.height() : area.y() + area.height(),
              isAbove ? area.y() : bar.y()));
    }
    return stems;
  }

  /** Returns whether a point is on a line or at most the given distance away. */
  public static boolean isNear(Line line, int x, int y, int distance) {
    for (int i = 1; i < line.points().size(); i++) {
      Point a = line.points().get(i - 1);
      Point b = line.points().get(i);
      int top = Math.min(a.y(), b.y());
      int bottom = Math.max(a.y(), b.y());
      if (y >= top - distance && y <= bottom + distance) {
        double part = Math.max(0, Math.min(1, (y - a.y()) / (double) (b.y() - a.y())));
        // Close to the drawn curve, which begins and ends vertically.
        double bent = part * part * (3 - 2 * part);
        if (Math.abs(a.x() + bent * (b.x() - a.x()) - x) <= distance) {
          return true;
        }
      }
    }
    return false;
  }

  /** Returns the font size for a line, which is also the distance of its baseline from the top. */
  public static int fontSize(int lineHeight) {
    return Math.max(1, lineHeight * 3 / 4);
  }

  /** Returns the texts of a box with their positions: centred, one below the other. */
  public static List<PlacedText> texts(Box box, TextSizes sizes) {
    int height = box.texts().stream().mapToInt(text -> sizes.height(text.title())).sum();
    Point center = box.area().center();
    int y = center.y() - height / 2;
    List<PlacedText> placed = new ArrayList<>();
    for (Text text : box.texts()) {
      placed.add(new PlacedText(text, center.x() - text.width() / 2, y));
      y += sizes.height(text.title());
    }
    return placed;
  }
}

package dev.eventchain.roads.ground;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Line2D;
import java.util.List;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests distances of rectangles against those of their sides. */
class RectangleTest {

  private static final double ROUNDING = 1e-9;

  /** Sides of 0 m, too: lines and points. */
  private static Rectangle rectangle(int x, int y, int turn, int length, int width) {
    return new Rectangle(x / 100.0, y / 100.0, turn / 100.0, length / 10.0, width / 10.0);
  }

  private static List<Line2D> sides(Rectangle of) {
    double[] x = new double[4];
    double[] y = new double[4];
    for (int i = 0; i < 4; i++) {
      double ahead = (i == 0 || i == 3 ? 1 : -1) * of.length() / 2;
      double left = (i < 2 ? 1 : -1) * of.width() / 2;
      x[i] = of.x() + ahead * Math.cos(of.heading()) - left * Math.sin(of.heading());
      y[i] = of.y() + ahead * Math.sin(of.heading()) + left * Math.cos(of.heading());
    }
    return IntStream.range(0, 4)
        .mapToObj(i -> line(x[i], y[i], x[(i + 1) % 4], y[(i + 1) % 4]))
        .toList();
  }

  private static Line2D line(double x1, double y1, double x2, double y2) {
    return new Line2D.Double(x1, y1, x2, y2);
  }

  private static boolean holds(Rectangle one, double x, double y) {
    double cos = Math.cos(one.heading());
    double sin = Math.sin(one.heading());
    double ahead = (x - one.x()) * cos + (y - one.y()) * sin;
    double left = (y - one.y()) * cos - (x - one.x()) * sin;
    return Math.abs(ahead) <= one.length() / 2 && Math.abs(left) <= one.width() / 2;
  }

  /** Returns the distance of the sides, or 0 if they cross or one rectangle is in the other. */
  private static double expected(Rectangle one, Rectangle other) {
    if (holds(one, other.x(), other.y()) || holds(other, one.x(), one.y())) {
      return 0;
    }
    double nearest = Double.POSITIVE_INFINITY;
    for (Line2D first : sides(one)) {
      for (Line2D second : sides(other)) {
        nearest = Math.min(nearest, cross(first, second) ? 0 : apart(first, second));
      }
    }
    return nearest;
  }

  /** Returns whether two lines cross; Line2D takes points for lines in any direction. */
  private static boolean cross(Line2D first, Line2D second) {
    boolean arePoints =
        first.getP1().equals(first.getP2()) || second.getP1().equals(second.getP2());
    return !arePoints && first.intersectsLine(second);
  }

  private static double apart(Line2D first, Line2D second) {
    return Math.min(
        Math.min(first.ptSegDist(second.getP1()), first.ptSegDist(second.getP2())),
        Math.min(second.ptSegDist(first.getP1()), second.ptSegDist(first.getP2())));
  }

  @Property
  void distancesAreThoseOfTheSides(
      @ForAll @IntRange(min = -700, max = 700) int x,
      @ForAll @IntRange(min = -700, max = 700) int y,
      @ForAll @IntRange(min = -700, max = 700) int turn,
      @ForAll @IntRange(min = -700, max = 700) int otherTurn,
      @ForAll @IntRange(max = 60) int length,
      @ForAll @IntRange(max = 60) int width,
      @ForAll @IntRange(max = 60) int otherLength,
      @ForAll @IntRange(max = 60) int otherWidth) {
    Rectangle one = rectangle(0, 0, turn, length, width);
    Rectangle other = rectangle(x, y, otherTurn, otherLength, otherWidth);
    double distance = expected(one, other);
    assertEquals(distance, one.distance(other), ROUNDING);
    assertEquals(distance, other.distance(one), ROUNDING);
    assertTrue(one.separation(other) <= distance + ROUNDING);
    assertTrue(one.touches(other) == one.distance(other) <= 0);
  }

  @Test
  void linesAndPointsTouchWhatTheyAreIn() {
    Rectangle box = new Rectangle(0, 0, 0, 4, 2);
    Rectangle line = new Rectangle(0, 0, Math.PI / 2, 10, 0);
    Rectangle point = new Rectangle(1.5, 0.5, 1, 0, 0);
    assertEquals(0, box.distance(line));
    assertEquals(0, line.distance(box));
    assertEquals(0, box.distance(point));
    assertEquals(5, point.distance(new Rectangle(4.5, 4.5, 2, 0, 0)), ROUNDING);
  }
}

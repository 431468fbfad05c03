package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.model.diagram.ChainDiagram;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.model.diagram.ChainDiagram.Line;
import dev.eventchain.model.diagram.ChainDiagram.Point;
import java.util.Comparator;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;

/** Keyboard navigation in a diagram. */
final class DiagramKeys {

  private DiagramKeys() {}

  /**
   * Returns the target box of a key: along the lines for down and up, the neighbours for left and
   * right, the first for Home and the last for End.
   *
   * @param selected the box to start from; negative for none
   * @return the box to start from if the key leads nowhere
   */
  static int next(ChainDiagram diagram, int selected, int keyCode) {
    if (diagram.boxes().isEmpty()) {
      return -1;
    } else if (selected < 0 || keyCode == SWT.HOME) {
      return extreme(diagram, true);
    }
    return switch (keyCode) {
      case SWT.END -> extreme(diagram, false);
      case SWT.ARROW_DOWN -> along(diagram, selected, true);
      case SWT.ARROW_UP -> along(diagram, selected, false);
      case SWT.ARROW_LEFT, SWT.ARROW_RIGHT -> beside(diagram, selected, keyCode == SWT.ARROW_RIGHT);
      default -> selected;
    };
  }

  private static Point center(ChainDiagram diagram, int index) {
    return diagram.boxes().get(index).area().center();
  }

  private static int extreme(ChainDiagram diagram, boolean first) {
    Comparator<Integer> order =
        Comparator.<Integer>comparingInt(i -> center(diagram, i).y())
            .thenComparingInt(i -> center(diagram, i).x());
    return IntStream.range(0, diagram.boxes().size())
        .boxed()
        .min(first ? order : order.reversed())
        .orElse(-1);
  }

  private static int along(ChainDiagram diagram, int selected, boolean down) {
    int x = center(diagram, selected).x();
    return diagram.lines().stream()
        .filter(line -> (down ? line.from() : line.to()) == selected)
        .sorted(Comparator.comparing(Line::isBack))
        .map(line -> down ? line.to() : line.from())
        .min(Comparator.comparingInt(other -> Math.abs(center(diagram, other).x() - x)))
        .orElse(selected);
  }

  /** Returns the nearest box of the same layer. */
  private static int beside(ChainDiagram diagram, int selected, boolean right) {
    Box box = diagram.boxes().get(selected);
    Point from = box.area().center();
    return IntStream.range(0, diagram.boxes().size())
        .boxed()
        .filter(i -> Math.abs(center(diagram, i).y() - from.y()) < box.area().height() / 2)
        .filter(i -> right ? center(diagram, i).x() > from.x() : center(diagram, i).x() < from.x())
        .min(Comparator.comparingInt(i -> Math.abs(center(diagram, i).x() - from.x())))
        .orElse(selected);
  }
}

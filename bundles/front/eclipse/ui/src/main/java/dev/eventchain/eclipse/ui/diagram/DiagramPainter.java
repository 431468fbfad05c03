package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.model.diagram.ChainDiagram;
import dev.eventchain.model.diagram.ChainDiagram.Area;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.ChainDiagram.Line;
import dev.eventchain.model.diagram.ChainDiagram.LineKind;
import dev.eventchain.model.diagram.ChainDiagram.Point;
import dev.eventchain.model.diagram.Shapes;
import dev.eventchain.model.diagram.TextSizes;
import java.util.List;
import org.eclipse.core.resources.IMarker;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.Path;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.ui.ISharedImages;
import org.eclipse.ui.PlatformUI;

/** Paints a diagram at 100 %; the caller scales and moves the graphics context. */
final class DiagramPainter {

  private static final int ROUND = 16;
  private static final int ARROW = 8;

  private final GC gc;
  private final DiagramColors colors;
  private final TextSizes sizes;

  DiagramPainter(GC gc, DiagramColors colors, TextSizes sizes) {
    this.gc = gc;
    this.colors = colors;
    this.sizes = sizes;
    gc.setAntialias(SWT.ON);
    gc.setTextAntialias(SWT.ON);
    gc.setLineJoin(SWT.JOIN_ROUND);
  }

  /**
   * Paints the visible part.
   *
   * @param problems the worst severity for each box, as in {@link IMarker}; negative for none
   * @param selected the index of the selected box; negative for none
   * @param seen the visible part
   */
  void paint(ChainDiagram diagram, List<Integer> problems, int selected, Rectangle seen) {
    for (Line line : diagram.lines()) {
      if (seen.intersects(bounds(line))) {
        paint(line);
      }
    }
    for (int i = 0; i < diagram.boxes().size(); i++) {
      Box box = diagram.boxes().get(i);
      Area area = box.area();
      if (seen.intersects(area.x() - 20, area.y() - 20, area.width() + 40, area.height() + 40)) {
        paint(box, i == selected, problems.isEmpty() ? -1 : problems.get(i));
      }
    }
  }

  private static Rectangle bounds(Line line) {
    Point first = line.points().get(0);
    Rectangle bounds = new Rectangle(first.x() - ARROW, first.y(), 2 * ARROW, 1);
    line.points().forEach(p -> bounds.add(new Rectangle(p.x() - ARROW, p.y(), 2 * ARROW, 1)));
    return bounds;
  }

  private void paint(Line line) {
    List<Point> points = line.points();
    Path path = new Path(gc.getDevice());
    path.moveTo(points.get(0).x(), points.get(0).y());
    for (int i = 1; i < points.size(); i++) {
      Point from = points.get(i - 1);
      Point to = points.get(i);
      float middle = (from.y() + to.y()) / 2f;
      path.cubicTo(from.x(), middle, to.x(), middle, to.x(), to.y());
    }
    boolean dashed = line.isBack() || line.kind() == LineKind.NEXT_STEP;
    gc.setLineStyle(dashed ? SWT.LINE_DASH : SWT.LINE_SOLID);
    gc.setLineWidth(1);
    gc.setForeground(colors.line());
    gc.setBackground(colors.line());
    gc.drawPath(path);
    path.dispose();
    gc.setLineStyle(SWT.LINE_SOLID);
    Point end = points.get(points.size() - 1);
    int back = end.y() > points.get(points.size() - 2).y() ? -ARROW : ARROW;
    int half = ARROW / 2;
    gc.fillPolygon(
        new int[] {
          end.x(), end.y(), end.x() - half, end.y() + back, end.x() + half, end.y() + back
        });
  }

  private void paint(Box box, boolean isSelected, int severity) {
    gc.setForeground(colors.line());
    gc.setBackground(colors.line());
    gc.setLineWidth(1);
    box.bars().forEach(bar -> gc.fillRectangle(bar.x(), bar.y(), bar.width(), bar.height()));
    Shapes.stems(box).forEach(stem -> gc.drawLine(stem.x(), stem.from(), stem.x(), stem.to()));
    Path outline = outline(box);
    if (isSelected) {
      gc.setForeground(colors.selection());
      gc.setLineWidth(7);
      gc.drawPath(outline);
    }
    gc.setBackground(
        box.generated()
            ? colors.generated()
            : box.kind() == Kind.COMPONENT ? colors.component() : colors.background());
    gc.fillPath(outline);
    boolean isBold = severity >= IMarker.SEVERITY_WARNING;
    gc.setForeground(border(box, severity));
    gc.setLineWidth(isBold ? 2 : 1);
    gc.drawPath(outline);
    outline.dispose();
    Shapes.texts(box, sizes).forEach(this::paint);
    if (isBold) {
      paintSign(box, severity);
    }
  }

  private Path outline(Box box) {
    Path path = new Path(gc.getDevice());
    if (box.kind() == Kind.COMPONENT) {
      Area area = box.area();
      float right = area.x() + area.width();
      float bottom = area.y() + area.height();
      path.addArc(right - ROUND, area.y(), ROUND, ROUND, 90, -90);
      path.addArc(right - ROUND, bottom - ROUND, ROUND, ROUND, 0, -90);
      path.addArc(area.x(), bottom - ROUND, ROUND, ROUND, 270, -90);
      path.addArc(area.x(), area.y(), ROUND, ROUND, 180, -90);
    } else {
      List<Point> corners = Shapes.outline(box);
      path.moveTo(corners.get(0).x(), corners.get(0).y());
      corners.forEach(corner -> path.lineTo(corner.x(), corner.y()));
    }
    path.close();
    return path;
  }

  private Color border(Box box, int severity) {
    if (severity >= IMarker.SEVERITY_WARNING) {
      return severity >= IMarker.SEVERITY_ERROR ? DiagramColors.error() : DiagramColors.warning();
    } else if (box.generated()) {
      return colors.accent();
    }
    return box.kind() == Kind.COMPONENT ? colors.componentBorder() : colors.topicBorder();
  }

  private void paint(Shapes.PlacedText placed) {
    gc.setFont(DiagramFonts.font(placed.text().title()));
    gc.setForeground(placed.text().title() ? colors.foreground() : colors.facts());
    gc.drawText(placed.text().text(), placed.x(), placed.y(), SWT.DRAW_TRANSPARENT);
  }

  /** Paints the sign over the upper left corner, where no line ends. */
  private void paintSign(Box box, int severity) {
    boolean isError = severity >= IMarker.SEVERITY_ERROR;
    Image sign =
        PlatformUI.getWorkbench()
            .getSharedImages()
            .getImage(isError ? ISharedImages.IMG_OBJS_ERROR_TSK : ISharedImages.IMG_OBJS_WARN_TSK);
    gc.drawImage(sign, box.area().x() - 7, box.area().y() - 7);
  }
}

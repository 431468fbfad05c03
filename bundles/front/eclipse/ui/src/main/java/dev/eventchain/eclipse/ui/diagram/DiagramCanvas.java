package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.model.diagram.ChainDiagram;
import dev.eventchain.model.diagram.ChainDiagram.Area;
import dev.eventchain.model.diagram.Shapes;
import java.util.List;
import java.util.function.IntFunction;
import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.ACC;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.Transform;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.ScrollBar;

/** Shows a diagram, with scrolling, zooming and the selection of a box. */
final class DiagramCanvas {

  private static final double STEP = 1.2;
  private static final double LEAST = 0.05;
  private static final double MOST = 5;

  private final Canvas canvas;
  private final DiagramColors.Source colors;
  private ChainDiagram diagram = new ChainDiagram("", List.of(), List.of(), 0, 0);
  private List<Integer> problems = List.of();
  private boolean isStale;
  private int selected = -1;
  private double zoom = 1;
  private String name = "";
  private IntFunction<String> texts = index -> "";

  DiagramCanvas(Composite parent) {
    canvas = new Canvas(parent, SWT.H_SCROLL | SWT.V_SCROLL | SWT.DOUBLE_BUFFERED);
    canvas.setBackground(parent.getDisplay().getSystemColor(SWT.COLOR_LIST_BACKGROUND));
    canvas.setForeground(parent.getDisplay().getSystemColor(SWT.COLOR_LIST_FOREGROUND));
    colors = new DiagramColors.Source(canvas);
    canvas.addListener(SWT.Paint, this::paint);
    canvas.addListener(SWT.Resize, event -> updateBars());
    canvas.addListener(SWT.MouseVerticalWheel, this::wheel);
    canvas.getHorizontalBar().addListener(SWT.Selection, event -> canvas.redraw());
    canvas.getVerticalBar().addListener(SWT.Selection, event -> canvas.redraw());
    canvas
        .getAccessible()
        .addAccessibleListener(
            new AccessibleAdapter() {
              @Override
              public void getName(AccessibleEvent e) {
                e.result = accessibleName();
              }
            });
  }

  Canvas control() {
    return canvas;
  }

  ChainDiagram diagram() {
    return diagram;
  }

  int selected() {
    return selected;
  }

  /**
   * Shows a diagram.
   *
   * @param shownName its name for screen readers
   * @param describe returns the description of a box for screen readers
   */
  void show(ChainDiagram shown, String shownName, IntFunction<String> describe) {
    diagram = shown;
    name = shownName;
    texts = describe;
    problems = List.of();
    selected = -1;
    isStale = false;
    updateBars();
  }

  /** Draws the diagram as outdated. */
  void fade() {
    isStale = true;
    canvas.redraw();
  }

  void mark(List<Integer> severities) {
    problems = severities;
    canvas.redraw();
  }

  /** Selects a box and scrolls to it; a negative index selects none. */
  void select(int index) {
    selected = index;
    if (index >= 0) {
      reveal(diagram.boxes().get(index).area());
    }
    canvas.redraw();
    canvas.getAccessible().sendEvent(ACC.EVENT_NAME_CHANGED, null);
  }

  private String accessibleName() {
    return selected < 0 ? name : name + ", " + texts.apply(selected);
  }

  /** Returns the point of the diagram under a point of the control. */
  Point toDiagram(int x, int y) {
    Point origin = origin();
    return new Point((int) ((x - origin.x) / zoom), (int) ((y - origin.y) / zoom));
  }

  /**
   * Returns the box at a point of the control, else the box whose line is there; negative if there
   * is none.
   */
  int boxAt(int x, int y) {
    Point point = toDiagram(x, y);
    for (int i = 0; i < diagram.boxes().size(); i++) {
      if (diagram.boxes().get(i).area().isNear(point.x, point.y, 2)) {
        return i;
      }
    }
    return diagram.lines().stream()
        .filter(line -> Shapes.isNear(line, point.x, point.y, 5))
        .findFirst()
        .map(line -> isTopic(line.from()) ? line.from() : line.to())
        .orElse(-1);
  }

  private boolean isTopic(int index) {
    return diagram.boxes().get(index).kind() != ChainDiagram.Kind.COMPONENT;
  }

  void zoomIn() {
    zoom(zoom * STEP, canvas.getClientArea().width / 2, canvas.getClientArea().height / 2);
  }

  void zoomOut() {
    zoom(zoom / STEP, canvas.getClientArea().width / 2, canvas.getClientArea().height / 2);
  }

  /** Zooms to 100 % and scrolls to the upper left corner. */
  void zoomToOriginal() {
    zoom(1, 0, 0);
    scrollTo(0, 0);
  }

  /** Zooms so that the whole diagram fits, to at most 100 %. */
  void zoomToFit() {
    Rectangle client = canvas.getClientArea();
    double width = (double) client.width / Math.max(1, diagram.width());
    double height = (double) client.height / Math.max(1, diagram.height());
    zoom(Math.min(1, Math.min(width, height)), 0, 0);
    scrollTo(0, 0);
  }

  /** Zooms around a point of the control, which stays over the same point of the diagram. */
  private void zoom(double factor, int x, int y) {
    Point fixed = toDiagram(x, y);
    zoom = Math.max(LEAST, Math.min(MOST, factor));
    updateBars();
    scrollTo((int) (fixed.x * zoom) - x, (int) (fixed.y * zoom) - y);
  }

  private void wheel(Event event) {
    if ((event.stateMask & SWT.MOD1) != 0) {
      event.doit = false;
      zoom(event.count > 0 ? zoom * STEP : zoom / STEP, event.x, event.y);
    }
  }

  private void updateBars() {
    Rectangle client = canvas.getClientArea();
    update(canvas.getHorizontalBar(), client.width, (int) Math.ceil(diagram.width() * zoom));
    update(canvas.getVerticalBar(), client.height, (int) Math.ceil(diagram.height() * zoom));
    canvas.redraw();
  }

  private static void update(ScrollBar bar, int seen, int all) {
    int most = Math.max(1, all);
    int thumb = Math.max(1, Math.min(seen, most));
    bar.setValues(
        Math.min(bar.getSelection(), most - thumb), 0, most, thumb, 20, Math.max(1, seen - 20));
    bar.setEnabled(all > seen);
    bar.setVisible(all > seen);
  }

  private void scrollTo(int x, int y) {
    canvas.getHorizontalBar().setSelection(Math.max(0, x));
    canvas.getVerticalBar().setSelection(Math.max(0, y));
    canvas.redraw();
  }

  /** Returns the origin of the diagram: centred if it is smaller than the control. */
  private Point origin() {
    Rectangle client = canvas.getClientArea();
    int width = (int) Math.ceil(diagram.width() * zoom);
    int x =
        width < client.width
            ? (client.width - width) / 2
            : -canvas.getHorizontalBar().getSelection();
    int height = (int) Math.ceil(diagram.height() * zoom);
    return new Point(x, height < client.height ? 0 : -canvas.getVerticalBar().getSelection());
  }

  private void reveal(Area area) {
    Rectangle client = canvas.getClientArea();
    Point origin = origin();
    int left = (int) ((area.x() - 12) * zoom);
    int right = (int) ((area.x() + area.width() + 12) * zoom);
    int top = (int) ((area.y() - 16) * zoom);
    int bottom = (int) ((area.y() + area.height() + 16) * zoom);
    scrollTo(
        reveal(Math.max(0, -origin.x), client.width, left, right),
        reveal(Math.max(0, -origin.y), client.height, top, bottom));
  }

  private static int reveal(int scrolled, int seen, int first, int last) {
    return first < scrolled || last - first > seen ? first : Math.max(scrolled, last - seen);
  }

  private void paint(Event event) {
    GC gc = event.gc;
    Point origin = origin();
    Transform transform = new Transform(gc.getDevice());
    transform.translate(origin.x, origin.y);
    transform.scale((float) zoom, (float) zoom);
    Point from = toDiagram(event.x, event.y);
    Point to = toDiagram(event.x + event.width, event.y + event.height);
    Rectangle seen = new Rectangle(from.x - 1, from.y - 1, to.x - from.x + 2, to.y - from.y + 2);
    gc.setTransform(transform);
    gc.setAlpha(isStale ? 90 : 255);
    try (DiagramFonts fonts = new DiagramFonts(canvas.getDisplay())) {
      new DiagramPainter(gc, colors.get(), fonts).paint(diagram, problems, selected, seen);
    }
    gc.setTransform(null);
    transform.dispose();
  }
}

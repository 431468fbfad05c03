package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.model.diagram.ChainDiagram;
import java.util.List;
import java.util.function.IntFunction;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Event;

/** Handles mouse and keyboard input in a diagram. */
final class DiagramInput {

  private final DiagramCanvas canvas;
  private final IntFunction<List<String>> problems;
  private final Listener listener;
  private ChainDiagram hoveredIn;
  private int hovered = -1;

  /** A listener for boxes; a negative index means none. */
  interface Listener {
    /** Called when the keyboard selects a box. */
    void moved(int box);

    /** Called when the mouse selects a box. */
    void clicked(int box);

    /** Called when a box is to be opened. */
    void opened(int box);
  }

  /**
   * Listens to a canvas.
   *
   * @param problems returns the problems of a box
   */
  DiagramInput(DiagramCanvas canvas, IntFunction<List<String>> problems, Listener listener) {
    this.canvas = canvas;
    this.problems = problems;
    this.listener = listener;
    Canvas control = canvas.control();
    control.addListener(SWT.MouseDown, this::pressed);
    control.addListener(SWT.MouseDoubleClick, event -> openSelected());
    control.addListener(SWT.MouseMove, this::moved);
    control.addListener(SWT.KeyDown, this::key);
    control.addListener(SWT.Traverse, DiagramInput::traverse);
  }

  private void pressed(Event event) {
    canvas.control().setFocus();
    if (event.button == 1) {
      listener.clicked(canvas.boxAt(event.x, event.y));
    }
  }

  private void moved(Event event) {
    int index = canvas.boxAt(event.x, event.y);
    if (index != hovered || hoveredIn != canvas.diagram()) {
      hoveredIn = canvas.diagram();
      hovered = index;
      canvas
          .control()
          .setToolTipText(
              index < 0
                  ? null
                  : DiagramTexts.tooltip(canvas.diagram(), index, problems.apply(index)));
    }
  }

  private void openSelected() {
    if (canvas.selected() >= 0) {
      listener.opened(canvas.selected());
    }
  }

  private void key(Event event) {
    if (event.keyCode == SWT.CR || event.keyCode == SWT.KEYPAD_CR) {
      openSelected();
    } else if (event.character == '+') {
      canvas.zoomIn();
    } else if (event.character == '-') {
      canvas.zoomOut();
    } else if (event.character == '0') {
      canvas.zoomToOriginal();
    } else if (isMove(event.keyCode)) {
      int next = DiagramKeys.next(canvas.diagram(), canvas.selected(), event.keyCode);
      if (next != canvas.selected()) {
        listener.moved(next);
      }
    }
  }

  private static boolean isMove(int keyCode) {
    return switch (keyCode) {
      case SWT.ARROW_UP, SWT.ARROW_DOWN, SWT.ARROW_LEFT, SWT.ARROW_RIGHT, SWT.HOME, SWT.END -> true;
      default -> false;
    };
  }

  /** Handles traversal: Tab leaves the diagram; arrows and Enter are handled in it. */
  private static void traverse(Event event) {
    event.doit =
        event.detail == SWT.TRAVERSE_TAB_NEXT
            || event.detail == SWT.TRAVERSE_TAB_PREVIOUS
            || event.detail == SWT.TRAVERSE_PAGE_NEXT
            || event.detail == SWT.TRAVERSE_PAGE_PREVIOUS;
  }
}

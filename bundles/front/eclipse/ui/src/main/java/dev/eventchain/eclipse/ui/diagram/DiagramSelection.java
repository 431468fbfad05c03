package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.model.diagram.ChainDiagram.Box;
import java.util.List;
import org.eclipse.core.runtime.ListenerList;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.viewers.ISelection;
import org.eclipse.jface.viewers.ISelectionChangedListener;
import org.eclipse.jface.viewers.ISelectionProvider;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.jface.viewers.SelectionChangedEvent;
import org.eclipse.jface.viewers.StructuredSelection;

/** The element of the selected box, as selection for the workbench. */
final class DiagramSelection implements ISelectionProvider {

  private final ListenerList<ISelectionChangedListener> listeners = new ListenerList<>();
  private final DiagramCanvas canvas;

  DiagramSelection(DiagramCanvas canvas) {
    this.canvas = canvas;
  }

  /** Selects a box and notifies the workbench; a negative index selects none. */
  void select(int index) {
    canvas.select(index);
    SelectionChangedEvent event = new SelectionChangedEvent(this, getSelection());
    listeners.forEach(listener -> listener.selectionChanged(event));
  }

  /** Marks the box of an element or of one in it, without a notification: others selected it. */
  void show(EObject element) {
    for (EObject each = element; each != null; each = each.eContainer()) {
      int index = indexOf(each);
      if (index >= 0) {
        canvas.select(index);
        return;
      }
    }
  }

  private int indexOf(EObject element) {
    List<Box> boxes = canvas.diagram().boxes();
    for (int i = 0; i < boxes.size(); i++) {
      if (boxes.get(i).elements().contains(element)) {
        return i;
      }
    }
    return -1;
  }

  /** Returns the path of the selected element; empty if there is none. */
  String path() {
    return canvas.selected() < 0
        ? ""
        : Problems.path(canvas.diagram().boxes().get(canvas.selected()).element());
  }

  /**
   * Selects an element again in another diagram, or the element with the same path there.
   *
   * @param path the previous {@link #path()}
   * @param before the previous element; if it still exists, listeners are not notified
   */
  void restore(String path, Object before) {
    if (path.isEmpty()) {
      return;
    }
    List<Box> boxes = canvas.diagram().boxes();
    int index = 0;
    while (index < boxes.size() && !Problems.path(boxes.get(index).element()).equals(path)) {
      index++;
    }
    if (index < boxes.size() && boxes.get(index).element() == before) {
      canvas.select(index);
    } else {
      select(index < boxes.size() ? index : -1);
    }
  }

  @Override
  public IStructuredSelection getSelection() {
    int index = canvas.selected();
    return index < 0
        ? StructuredSelection.EMPTY
        : new StructuredSelection(canvas.diagram().boxes().get(index).element());
  }

  @Override
  public void setSelection(ISelection selection) {
    if (selection instanceof IStructuredSelection structured
        && structured.getFirstElement() instanceof EObject element) {
      select(indexOf(element));
    } else {
      select(-1);
    }
  }

  @Override
  public void addSelectionChangedListener(ISelectionChangedListener listener) {
    listeners.add(listener);
  }

  @Override
  public void removeSelectionChangedListener(ISelectionChangedListener listener) {
    listeners.remove(listener);
  }
}

package dev.eventchain.eclipse.ui.editor;

import java.util.Arrays;
import java.util.function.Consumer;
import org.eclipse.core.runtime.ListenerList;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.viewers.ISelection;
import org.eclipse.jface.viewers.ISelectionChangedListener;
import org.eclipse.jface.viewers.ISelectionProvider;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.jface.viewers.SelectionChangedEvent;
import org.eclipse.jface.viewers.StructuredSelection;

/** The selection that an editor provides to the workbench: elements of the chain only. */
final class ChainSelection implements ISelectionProvider {

  private final ListenerList<ISelectionChangedListener> listeners = new ListenerList<>();
  private final Consumer<EObject> reveal;
  private IStructuredSelection selection = StructuredSelection.EMPTY;

  /**
   * @param reveal selects an element in the editor
   */
  ChainSelection(Consumer<EObject> reveal) {
    this.reveal = reveal;
  }

  /** Updates the selection after a change in the editor. */
  void changed(IStructuredSelection shown) {
    selection =
        new StructuredSelection(
            Arrays.stream(shown.toArray()).filter(EObject.class::isInstance).toArray());
    SelectionChangedEvent event = new SelectionChangedEvent(this, selection);
    listeners.forEach(listener -> listener.selectionChanged(event));
  }

  /** Returns the first selected element; null if there is none. */
  EObject first() {
    return (EObject) selection.getFirstElement();
  }

  @Override
  public void addSelectionChangedListener(ISelectionChangedListener listener) {
    listeners.add(listener);
  }

  @Override
  public void removeSelectionChangedListener(ISelectionChangedListener listener) {
    listeners.remove(listener);
  }

  @Override
  public ISelection getSelection() {
    return selection;
  }

  @Override
  public void setSelection(ISelection wanted) {
    if (wanted instanceof IStructuredSelection elements
        && elements.getFirstElement() instanceof EObject element
        && element != selection.getFirstElement()) {
      reveal.accept(element);
    }
  }
}

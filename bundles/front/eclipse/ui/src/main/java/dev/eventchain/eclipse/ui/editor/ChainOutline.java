package dev.eventchain.eclipse.ui.editor;

import dev.eventchain.eclipse.ui.editor.model.TreeContent;
import dev.eventchain.eclipse.ui.editor.model.TreeLabels;
import java.util.function.Consumer;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.jface.viewers.SelectionChangedEvent;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.views.contentoutline.ContentOutlinePage;

/** The chain of an editor in the Outline view, without details of findings. */
final class ChainOutline extends ContentOutlinePage {

  private final Consumer<EObject> reveal;
  private ModelPage page;

  /**
   * @param reveal selects an element in the editor
   */
  ChainOutline(Consumer<EObject> reveal) {
    this.reveal = reveal;
  }

  @Override
  public void createControl(Composite parent) {
    super.createControl(parent);
    getTreeViewer().setContentProvider(new TreeContent());
    show(page);
  }

  /** Shows another state of the editor; null without a chain. */
  void show(ModelPage shown) {
    page = shown;
    if (getTreeViewer() == null || getTreeViewer().getControl().isDisposed()) {
      return;
    }
    if (page == null) {
      getTreeViewer().setInput(new Object[0]);
      return;
    }
    getTreeViewer().setLabelProvider(new TreeLabels(page.findings()));
    getTreeViewer().setInput(new Object[] {page.chain()});
    getTreeViewer().expandToLevel(2);
  }

  /** Refreshes after a change of the model or its findings. */
  void refresh() {
    if (getTreeViewer() != null && !getTreeViewer().getControl().isDisposed()) {
      getTreeViewer().refresh(true);
    }
  }

  @Override
  public void selectionChanged(SelectionChangedEvent event) {
    super.selectionChanged(event);
    IStructuredSelection selection = event.getStructuredSelection();
    if (getTreeViewer().getControl().isFocusControl()
        && selection.getFirstElement() instanceof EObject element) {
      reveal.accept(element);
    }
  }
}

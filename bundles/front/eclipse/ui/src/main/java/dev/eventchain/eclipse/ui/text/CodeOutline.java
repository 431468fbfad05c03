package dev.eventchain.eclipse.ui.text;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.eclipse.jface.viewers.ITreeContentProvider;
import org.eclipse.jface.viewers.LabelProvider;
import org.eclipse.jface.viewers.TreeViewer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.views.contentoutline.ContentOutlinePage;

/** The outline of a file's declarations; a click selects one. */
final class CodeOutline extends ContentOutlinePage {

  private final Supplier<List<Outlines.Entry>> entries;
  private final Consumer<Outlines.Entry> show;

  CodeOutline(Supplier<List<Outlines.Entry>> entries, Consumer<Outlines.Entry> show) {
    this.entries = entries;
    this.show = show;
  }

  @Override
  public void createControl(Composite parent) {
    super.createControl(parent);
    TreeViewer viewer = getTreeViewer();
    viewer.setContentProvider(new Content());
    viewer.setLabelProvider(
        new LabelProvider() {
          @Override
          public String getText(Object element) {
            return ((Outlines.Entry) element).label();
          }
        });
    viewer.setInput(entries.get());
    viewer.addSelectionChangedListener(
        event -> {
          Object first = event.getStructuredSelection().getFirstElement();
          if (first instanceof Outlines.Entry entry && getControl().isFocusControl()) {
            show.accept(entry);
          }
        });
  }

  /** Reads the text again. */
  void refresh() {
    if (getTreeViewer() != null && !getControl().isDisposed()) {
      getTreeViewer().setInput(entries.get());
    }
  }

  private static final class Content implements ITreeContentProvider {
    @Override
    public Object[] getElements(Object input) {
      return ((List<?>) input).toArray();
    }

    @Override
    public Object[] getChildren(Object parent) {
      return new Object[0];
    }

    @Override
    public Object getParent(Object element) {
      return null; // the list is flat
    }

    @Override
    public boolean hasChildren(Object element) {
      return false;
    }
  }
}

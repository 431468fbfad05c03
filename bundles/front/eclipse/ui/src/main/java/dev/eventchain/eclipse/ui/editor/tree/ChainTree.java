package dev.eventchain.eclipse.ui.editor.tree;

import dev.eventchain.eclipse.ui.editor.model.Labels;
import dev.eventchain.eclipse.ui.editor.model.TreeContent;
import dev.eventchain.eclipse.ui.editor.model.TreeLabels;
import dev.eventchain.model.eventchain.EventChain;
import java.util.Arrays;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.viewers.ITreeSelection;
import org.eclipse.jface.viewers.StructuredSelection;
import org.eclipse.jface.viewers.TreePath;
import org.eclipse.jface.viewers.TreeViewer;
import org.eclipse.jface.viewers.Viewer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.dialogs.FilteredTree;
import org.eclipse.ui.dialogs.PatternFilter;

/** The tree of a chain, with a filter field. */
public final class ChainTree {

  private final TreeViewer viewer;

  public ChainTree(Composite parent, TreeLabels.Findings findings) {
    FilteredTree tree =
        new FilteredTree(
            parent, SWT.MULTI | SWT.H_SCROLL | SWT.V_SCROLL | SWT.BORDER, new Filter(), true, true);
    viewer = tree.getViewer();
    viewer.setContentProvider(new TreeContent());
    viewer.setLabelProvider(new TreeLabels(findings));
    TreeLabels.addTooltips(viewer);
  }

  public TreeViewer viewer() {
    return viewer;
  }

  /** Shows a chain, with its components expanded. */
  public void show(EventChain chain) {
    viewer.setInput(new Object[] {chain});
    viewer.expandToLevel(2);
  }

  /** Selects an element and expands its parent. */
  public void select(Object element) {
    viewer.setSelection(new StructuredSelection(element), true);
  }

  /** Returns the selected elements and headings. */
  List<Object> selection() {
    return Arrays.asList(viewer.getStructuredSelection().toArray());
  }

  /** Returns the elements that are selected. */
  List<EObject> elements() {
    return selection().stream()
        .filter(EObject.class::isInstance)
        .map(EObject.class::cast)
        .distinct()
        .toList();
  }

  /** Returns the parent of the first selected element in the tree. */
  Object parent() {
    ITreeSelection selection = viewer.getStructuredSelection();
    TreePath[] paths = selection.getPaths();
    int segments = paths.length == 0 ? 0 : paths[0].getSegmentCount();
    return segments < 2 ? null : paths[0].getSegment(segments - 2);
  }

  /** Filters by the words that the tree shows. */
  private static final class Filter extends PatternFilter {

    private Filter() {
      setIncludeLeadingWildcard(true);
    }

    @Override
    protected boolean isLeafMatch(Viewer viewer, Object element) {
      return wordMatches(Labels.of(element).text());
    }
  }
}

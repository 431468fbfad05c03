package dev.eventchain.eclipse.ui.editor.tree;

import dev.eventchain.eclipse.ui.editor.model.Structure;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.util.LocalSelectionTransfer;
import org.eclipse.jface.viewers.TreeViewer;
import org.eclipse.jface.viewers.ViewerDropAdapter;
import org.eclipse.swt.dnd.DND;
import org.eclipse.swt.dnd.DragSourceAdapter;
import org.eclipse.swt.dnd.DragSourceEvent;
import org.eclipse.swt.dnd.Transfer;
import org.eclipse.swt.dnd.TransferData;

/**
 * Dragging in the tree: an element within its list, and data from one component to another, which
 * then reads or writes it instead.
 */
final class TreeDrag extends ViewerDropAdapter {

  private static final Transfer[] TRANSFERS = {LocalSelectionTransfer.getTransfer()};

  private final ChainTree tree;
  private final Structure structure;

  /** The dragged element and its parent; null if nothing is dragged. */
  private EObject dragged;

  private Object from;

  private TreeDrag(ChainTree tree, Structure structure) {
    super(tree.viewer());
    this.tree = tree;
    this.structure = structure;
  }

  /** Enables dragging of elements of a tree. */
  static void enable(ChainTree tree, Structure structure) {
    TreeDrag drop = new TreeDrag(tree, structure);
    TreeViewer viewer = tree.viewer();
    viewer.addDragSupport(DND.DROP_MOVE, TRANSFERS, drop.new Source());
    viewer.addDropSupport(DND.DROP_MOVE, TRANSFERS, drop);
  }

  private final class Source extends DragSourceAdapter {

    @Override
    public void dragStart(DragSourceEvent event) {
      event.doit = tree.selection().size() == 1 && tree.elements().size() == 1;
      if (event.doit) {
        dragged = tree.elements().get(0);
        from = tree.parent();
        LocalSelectionTransfer.getTransfer().setSelection(tree.viewer().getSelection());
      }
    }

    @Override
    public void dragFinished(DragSourceEvent event) {
      dragged = null;
      LocalSelectionTransfer.getTransfer().setSelection(null);
    }
  }

  @Override
  public boolean validateDrop(Object target, int operation, TransferData type) {
    if (dragged == null || target == dragged) {
      return false;
    }
    return getCurrentLocation() == LOCATION_ON
        ? dragged instanceof Data data
            && target instanceof SoftwareNode to
            && Structure.canGive(data, from, to)
        : target instanceof EObject neighbour && Structure.canMove(from, dragged, neighbour);
  }

  @Override
  public boolean performDrop(Object ignored) {
    EObject moved = dragged;
    Object target = getCurrentTarget();
    if (moved == null || !validateDrop(target, DND.DROP_MOVE, null)) {
      return false;
    }
    if (getCurrentLocation() == LOCATION_ON) {
      structure.give((Data) moved, from, (SoftwareNode) target);
    } else {
      structure.move(from, moved, (EObject) target, getCurrentLocation() == LOCATION_AFTER);
    }
    tree.select(moved);
    return true;
  }
}

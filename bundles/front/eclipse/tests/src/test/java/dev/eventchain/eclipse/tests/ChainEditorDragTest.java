package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.xmi.XmiStore;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.jface.util.LocalSelectionTransfer;
import org.eclipse.swt.dnd.DND;
import org.eclipse.swt.dnd.DragSource;
import org.eclipse.swt.dnd.DragSourceEvent;
import org.eclipse.swt.dnd.DragSourceListener;
import org.eclipse.swt.dnd.DropTarget;
import org.eclipse.swt.dnd.DropTargetEvent;
import org.eclipse.swt.dnd.DropTargetListener;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Tree;
import org.eclipse.swt.widgets.TreeItem;
import org.eclipse.swt.widgets.Widget;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IWorkbenchCommandConstants;
import org.eclipse.ui.dialogs.FilteredTree;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests dragging in the tree by SWT events, since the window system needs a person. */
class ChainEditorDragTest {

  private EditorBench bench;
  private IEditorPart editor;
  private byte[] bytes;

  @BeforeEach
  void open() {
    Workbench.require();
    bench = new EditorBench("chain-drag");
    bytes = XmiStore.toBytes(EditorBench.chain());
    IFile file = bench.file("chain.xmi", bytes);
    editor = EditorBench.open(file);
  }

  @AfterEach
  void close() {
    if (bench != null) {
      bench.close();
    }
  }

  private static Tree tree() {
    return EditorBench.find(
        Tree.class, each -> each.getParent().getParent() instanceof FilteredTree);
  }

  /**
   * Returns the middle of a component's line on the screen, or a place near its upper or lower end.
   */
  private static Point place(int component, double height) {
    return Workbench.run(
        () -> {
          TreeItem item = tree().getItem(0).getItem(component);
          Rectangle bounds = item.getBounds();
          return tree().toDisplay(bounds.x + 20, bounds.y + (int) (bounds.height * height));
        });
  }

  /** Returns an event as SWT creates it for the window system; only SWT can create one. */
  private static <T> T event(Class<T> type, Widget widget, TreeItem item, Point at)
      throws ReflectiveOperationException {
    Class<?> reported = type.getClassLoader().loadClass("org.eclipse.swt.dnd.DNDEvent");
    Constructor<?> constructor = reported.getDeclaredConstructor();
    constructor.setAccessible(true);
    Event event = (Event) constructor.newInstance();
    event.display = widget.getDisplay();
    event.widget = widget;
    event.item = item;
    event.x = at.x;
    event.y = at.y;
    event.detail = DND.DROP_MOVE;
    event.doit = true;
    set(event, "operations", DND.DROP_MOVE);
    set(event, "dataType", LocalSelectionTransfer.getTransfer().getSupportedTypes()[0]);
    set(event, "dataTypes", LocalSelectionTransfer.getTransfer().getSupportedTypes());
    return type.getConstructor(reported).newInstance(event);
  }

  private static void set(Event event, String name, Object value)
      throws ReflectiveOperationException {
    Field field = event.getClass().getDeclaredField(name);
    field.setAccessible(true);
    field.set(event, value);
  }

  /** Sends the tree the SWT events of dragging the selected element onto a component. */
  private static void drag(int component, double height) {
    Point at = place(component, height);
    Workbench.run(
        () -> {
          Tree tree = tree();
          TreeItem item = tree.getItem(0).getItem(component);
          DragSource source = (DragSource) tree.getData(DND.DRAG_SOURCE_KEY);
          DropTarget target = (DropTarget) tree.getData(DND.DROP_TARGET_KEY);
          DragSourceEvent start = event(DragSourceEvent.class, source, item, at);
          for (DragSourceListener listener : source.getDragListeners()) {
            listener.dragStart(start);
          }
          DropTargetEvent over = event(DropTargetEvent.class, target, item, at);
          for (DropTargetListener listener : target.getDropListeners()) {
            listener.dragEnter(over);
            listener.dragOver(over);
            listener.dropAccept(over);
            if (over.detail != DND.DROP_NONE) {
              listener.drop(over);
            }
          }
          for (DragSourceListener listener : source.getDragListeners()) {
            listener.dragFinished(start);
          }
          return at;
        });
  }

  private static List<String> names(EventChain chain) {
    return Workbench.run(() -> chain.getSoftware().stream().map(SoftwareNode::getName).toList());
  }

  @Test
  void componentIsDraggedAboveAnotherOneAndBackByUndo() {
    EventChain chain = EditorBench.chainOf(editor);
    List<String> before = names(chain);
    EditorBench.select(editor, chain.getSoftware().get(1));
    drag(0, 0.1);
    assertEquals(List.of(before.get(1), before.get(0)), names(chain).subList(0, 2));
    EditorBench.command(IWorkbenchCommandConstants.EDIT_UNDO);
    assertEquals(before, names(chain));
    assertArrayEquals(bytes, EditorBench.bytesOf(editor));
  }

  @Test
  void dataIsDraggedToAnotherComponent() {
    EventChain chain = EditorBench.chainOf(editor);
    SoftwareNode first = chain.getSoftware().get(0);
    SoftwareNode second = chain.getSoftware().get(1);
    Data data = second.getInput().get(0);
    EditorBench.select(editor, data);
    drag(0, 0.5);
    assertTrue(first.getInput().contains(data) && !second.getInput().contains(data));
    EditorBench.command(IWorkbenchCommandConstants.EDIT_UNDO);
    assertArrayEquals(bytes, EditorBench.bytesOf(editor));
  }

  @Test
  void componentIsNotDroppedIntoAnotherOne() {
    EventChain chain = EditorBench.chainOf(editor);
    EditorBench.select(editor, chain.getSoftware().get(1));
    drag(0, 0.5);
    assertArrayEquals(bytes, EditorBench.bytesOf(editor));
  }
}

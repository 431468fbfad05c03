package dev.eventchain.eclipse.ui.editor.tree;

import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.IAction;
import org.eclipse.jface.action.IMenuCreator;
import org.eclipse.jface.action.MenuManager;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Menu;
import org.eclipse.swt.widgets.ToolItem;
import org.eclipse.ui.ISharedImages;
import org.eclipse.ui.PlatformUI;

/** The tool with a menu of the elements that can be created. */
final class NewMenu extends Action implements IMenuCreator {

  private final TreeActions actions;
  private MenuManager menu = new MenuManager();

  NewMenu(TreeActions actions) {
    super("New", IAction.AS_DROP_DOWN_MENU);
    this.actions = actions;
    setToolTipText("New element");
    setImageDescriptor(
        PlatformUI.getWorkbench().getSharedImages().getImageDescriptor(ISharedImages.IMG_OBJ_ADD));
    setMenuCreator(this);
  }

  @Override
  public void runWithEvent(Event event) {
    if (event.widget instanceof ToolItem item) {
      Menu shown = getMenu(item.getParent());
      shown.setLocation(
          item.getParent()
              .toDisplay(item.getBounds().x, item.getBounds().y + item.getBounds().height));
      shown.setVisible(true);
    }
  }

  @Override
  public Menu getMenu(Control parent) {
    menu.dispose();
    menu = new MenuManager();
    actions.fillNew(menu);
    return menu.createContextMenu(parent);
  }

  @Override
  public Menu getMenu(Menu parent) {
    return null;
  }

  @Override
  public void dispose() {
    menu.dispose();
  }
}

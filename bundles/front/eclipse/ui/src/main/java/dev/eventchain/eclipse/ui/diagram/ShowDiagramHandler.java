package dev.eventchain.eclipse.ui.diagram;

import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.commands.ExecutionException;
import org.eclipse.jface.viewers.ISelection;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.PartInitException;
import org.eclipse.ui.handlers.HandlerUtil;

/** Opens the view for the selected file. */
public final class ShowDiagramHandler extends AbstractHandler {

  @Override
  public Object execute(ExecutionEvent event) throws ExecutionException {
    IWorkbenchWindow window = HandlerUtil.getActiveWorkbenchWindow(event);
    IWorkbenchPage page = window == null ? null : window.getActivePage();
    if (page == null) {
      return null;
    }
    ISelection selection = HandlerUtil.getCurrentSelection(event); // before the view is active
    try {
      if (page.showView(DiagramView.ID) instanceof DiagramView view) {
        ChainTracker.forFile(selection, view::show);
      }
    } catch (PartInitException e) {
      throw new ExecutionException("The diagram cannot be opened: " + e.getMessage(), e);
    }
    return null;
  }
}

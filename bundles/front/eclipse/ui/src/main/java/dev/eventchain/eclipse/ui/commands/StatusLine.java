package dev.eventchain.eclipse.ui.commands;

import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IViewPart;
import org.eclipse.ui.IWorkbenchPart;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.PlatformUI;

/** The line at the bottom of the window. */
final class StatusLine {

  private StatusLine() {}

  /** Shows a message until the next one; in the user interface's thread only. */
  static void show(String sentence) {
    IWorkbenchWindow window = PlatformUI.getWorkbench().getActiveWorkbenchWindow();
    IWorkbenchPart part =
        window == null || window.getActivePage() == null
            ? null
            : window.getActivePage().getActivePart();
    if (part instanceof IViewPart view) {
      view.getViewSite().getActionBars().getStatusLineManager().setMessage(sentence);
    } else if (part instanceof IEditorPart editor) {
      editor.getEditorSite().getActionBars().getStatusLineManager().setMessage(sentence);
    }
  }
}

package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.eclipse.FindingMarker;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.ide.IDE;

/** Shows elements in editors of their files. */
final class ElementOpener {

  private ElementOpener() {}

  /**
   * Opens the editor of a file, or brings it to the front, and shows an element there.
   *
   * @param element the path of the element
   * @param line its line, for editors that know only texts; 0 if unknown
   * @param activate true to give the editor the focus
   * @return the reason for a failure; empty on success
   */
  static String open(IWorkbenchPage page, IFile file, String element, int line, boolean activate) {
    if (!file.isAccessible()) {
      return file.getFullPath() + " no longer exists, or its project is closed.";
    }
    try {
      IEditorPart editor = IDE.openEditor(page, file, activate);
      if (editor != null) {
        show(editor, file, element, line);
      }
      return "";
    } catch (CoreException e) {
      return e.getStatus().getMessage();
    }
  }

  /** Shows an element by a temporary marker, since editors go to markers. */
  private static void show(IEditorPart editor, IFile file, String element, int line)
      throws CoreException {
    IMarker marker = file.createMarker(IMarker.TEXT);
    try {
      marker.setAttribute(IMarker.TRANSIENT, true);
      marker.setAttribute(FindingMarker.ELEMENT, element);
      if (line > 0) {
        marker.setAttribute(IMarker.LINE_NUMBER, line);
      }
      IDE.gotoMarker(editor, marker);
    } finally {
      marker.delete();
    }
  }
}

package dev.eventchain.eclipse.ui.commands;

import java.util.Map;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.console.IHyperlink;
import org.eclipse.ui.ide.IDE;

/**
 * Opens a file at a line.
 *
 * @param line from 1; 0 for the file as a whole
 */
record PlaceLink(IFile file, int line) implements IHyperlink {

  @Override
  public void linkEntered() {
    // The console underlines it.
  }

  @Override
  public void linkExited() {
    // As above.
  }

  @Override
  public void linkActivated() {
    IWorkbenchWindow window = PlatformUI.getWorkbench().getActiveWorkbenchWindow();
    if (window == null || !file.exists()) {
      return;
    }
    try {
      IMarker place = file.createMarker(IMarker.MARKER, Map.of(IMarker.LINE_NUMBER, line));
      try {
        IDE.openEditor(window.getActivePage(), place);
      } finally {
        place.delete();
      }
    } catch (CoreException e) {
      StatusLine.show("The file cannot be opened: " + e.getMessage());
    }
  }
}

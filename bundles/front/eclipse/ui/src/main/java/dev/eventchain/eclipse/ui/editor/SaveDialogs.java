package dev.eventchain.eclipse.ui.editor;

import java.util.Optional;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.IPath;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.jface.window.Window;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.dialogs.SaveAsDialog;

/** What an editor asks when its file is not as it was. */
final class SaveDialogs {

  private static final int FIRST = 0;

  /** The button that Enter presses where the first one would lose somebody's work. */
  private static final int SECOND = 1;

  private SaveDialogs() {}

  /** Whether the editor takes over what somebody else has written, and gives up its changes. */
  static boolean replace(Shell shell, IFile file) {
    return ask(
        shell,
        "File changed",
        file.getName()
            + " has been changed both on disk and here. Which version do you want to keep?",
        "Load the file",
        "Keep my changes",
        SECOND);
  }

  /** Whether the file is written over what somebody else has written meanwhile. */
  static boolean overwrite(Shell shell, IFile file) {
    return ask(
        shell,
        "File changed",
        file.getName() + " has been changed on disk since it was opened.",
        "Overwrite it",
        "Cancel",
        SECOND);
  }

  /**
   * Says that the file was not written.
   *
   * @return whether it is to be saved under another name
   */
  static boolean saveAs(Shell shell, IFile file, String reason) {
    return ask(
        shell,
        "Not saved",
        file.getName() + " was not written: " + reason,
        "Save As\u2026",
        "Cancel",
        FIRST);
  }

  /** Where to write the chain to; empty if nowhere. */
  static Optional<IFile> chooseFile(Shell shell, IFile file) {
    SaveAsDialog dialog = new SaveAsDialog(shell);
    dialog.setOriginalFile(file);
    IPath path = dialog.open() == Window.OK ? dialog.getResult() : null;
    return Optional.ofNullable(path).map(ResourcesPlugin.getWorkspace().getRoot()::getFile);
  }

  /** Says something that there is nothing to choose about. */
  static void inform(Shell shell, String text) {
    MessageDialog.openError(shell, "Event chain", text);
  }

  private static boolean ask(
      Shell shell, String title, String text, String yes, String no, int preselected) {
    String[] buttons = {yes, no};
    return new MessageDialog(shell, title, null, text, MessageDialog.WARNING, buttons, preselected)
            .open()
        == 0;
  }
}

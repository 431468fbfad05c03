package dev.eventchain.eclipse.ui.editor;

import java.util.Optional;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.IPath;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.jface.window.Window;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.dialogs.SaveAsDialog;

/** Dialogs of an editor whose file was changed or could not be written. */
final class SaveDialogs {

  private static final int FIRST = 0;

  /** Index of the default button where the first one would discard work. */
  private static final int SECOND = 1;

  private SaveDialogs() {}

  /** Asks whether to load the version of the file on disk and discard the editor's changes. */
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

  /** Asks whether to overwrite a file that was changed by somebody else in the meantime. */
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
   * Reports that the file was not written.
   *
   * @return true if the person chooses to save it under another name
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

  /** Asks for the file to write the chain to; empty if cancelled. */
  static Optional<IFile> chooseFile(Shell shell, IFile file) {
    SaveAsDialog dialog = new SaveAsDialog(shell);
    dialog.setOriginalFile(file);
    IPath path = dialog.open() == Window.OK ? dialog.getResult() : null;
    return Optional.ofNullable(path).map(ResourcesPlugin.getWorkspace().getRoot()::getFile);
  }

  /** Shows information without a choice. */
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

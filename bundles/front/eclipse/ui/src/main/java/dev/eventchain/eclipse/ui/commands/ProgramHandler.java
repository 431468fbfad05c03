package dev.eventchain.eclipse.ui.commands;

import dev.eventchain.eclipse.EventchainFolders;
import dev.eventchain.eclipse.Program;
import java.util.List;
import java.util.Optional;
import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IConfigurationElement;
import org.eclipse.core.runtime.IExecutableExtension;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.handlers.HandlerUtil;
import org.eclipse.ui.ide.IDE;

/**
 * Starts a command of {@code eventchain} on the selected project's folder; its extension names the
 * command: {@code generate}, {@code simulate}, {@code run}.
 */
public final class ProgramHandler extends AbstractHandler implements IExecutableExtension {

  private String command = "";

  @Override
  public void setInitializationData(
      IConfigurationElement configuration, String property, Object data) {
    command = String.valueOf(data);
  }

  @Override
  public Object execute(ExecutionEvent event) {
    Shell shell = HandlerUtil.getActiveShell(event);
    List<IResource> selected = Selected.resources(event);
    Optional<IContainer> folder =
        selected.stream().flatMap(each -> EventchainFolders.around(each).stream()).findFirst();
    if (folder.isEmpty()) {
      MessageDialog.openInformation(
          shell,
          "Eventchain",
          "Select a file of an Eventchain project: a folder with an eventchain.yaml. New >"
              + " Eventchain Project creates one.");
      return null;
    }
    try {
      Program program = Program.find();
      if (ProgramJob.isRunning(folder.get())) {
        MessageDialog.openInformation(
            shell,
            "Eventchain",
            "This project is already running. Wait until it finishes, or cancel it in the Progress"
                + " view.");
      } else if (IDE.saveAllEditors(new IResource[] {folder.get()}, true)) {
        new ProgramJob(program, command, folder.get()).start();
      }
    } catch (CoreException e) {
      MessageDialog.openError(shell, "Eventchain", e.getStatus().getMessage());
    }
    return null;
  }
}

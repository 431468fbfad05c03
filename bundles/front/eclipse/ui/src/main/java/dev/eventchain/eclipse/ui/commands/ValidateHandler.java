package dev.eventchain.eclipse.ui.commands;

import dev.eventchain.eclipse.CheckSummary;
import dev.eventchain.eclipse.ProjectChecks;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.ICoreRunnable;
import org.eclipse.core.runtime.jobs.Job;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.handlers.HandlerUtil;
import org.eclipse.ui.ide.IDE;

/**
 * Checks the selected resources, whether they have changed or not, also in projects without our
 * nature.
 */
public final class ValidateHandler extends AbstractHandler {

  @Override
  public Object execute(ExecutionEvent event) {
    List<IResource> selected = Selected.resources(event);
    if (!IDE.saveAllEditors(selected.toArray(IResource[]::new), true)) {
      return null; // the files on disk are checked, while people continue with their editors
    }
    Map<IProject, List<IResource>> byProject =
        selected.stream().collect(Collectors.groupingBy(IResource::getProject));
    Shell shell = HandlerUtil.getActiveShell(event);
    byProject.forEach((project, resources) -> start(project, resources, shell));
    return null;
  }

  private static void start(IProject project, List<IResource> resources, Shell shell) {
    Job job =
        Job.create(
            "Validating " + names(resources),
            (ICoreRunnable)
                monitor -> {
                  CheckSummary summary = ProjectChecks.of(project).check(resources, monitor);
                  tell(summary, names(resources), shell);
                });
    job.setRule(project);
    job.setUser(true);
    job.schedule();
  }

  /**
   * Shows a summary; a dialog reports that nothing was checked, since the status line is easily
   * overlooked.
   */
  private static void tell(CheckSummary summary, String names, Shell shell) {
    PlatformUI.getWorkbench()
        .getDisplay()
        .asyncExec(
            () -> {
              if (summary.isEmpty() && !shell.isDisposed()) {
                MessageDialog.openWarning(shell, "Validate", names + ": " + summary.words());
              } else {
                StatusLine.show(names + ": " + summary.words());
              }
            });
  }

  private static String names(List<IResource> resources) {
    String first = resources.get(0).getName();
    return resources.size() == 1 ? first : first + " and " + (resources.size() - 1) + " more";
  }
}

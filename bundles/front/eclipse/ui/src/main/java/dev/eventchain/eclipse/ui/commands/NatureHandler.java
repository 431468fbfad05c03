package dev.eventchain.eclipse.ui.commands;

import dev.eventchain.eclipse.EventchainCore;
import java.util.List;
import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.ICoreRunnable;
import org.eclipse.core.runtime.jobs.Job;

/** Turns checks on save on or off for the selected projects. */
public final class NatureHandler extends AbstractHandler {

  @Override
  public Object execute(ExecutionEvent event) {
    List<IProject> projects =
        Selected.resources(event).stream().map(IResource::getProject).distinct().toList();
    for (IProject project : projects) {
      boolean wanted = !EventchainCore.hasNature(project);
      Job job =
          Job.create(
              "Checks of " + project.getName(),
              (ICoreRunnable) monitor -> EventchainCore.setNature(project, wanted, monitor));
      job.setRule(project.getWorkspace().getRoot());
      job.schedule();
    }
    return null;
  }
}

package dev.eventchain.eclipse.ui.wizards;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.Program;
import dev.eventchain.project.ProjectLayout;
import java.lang.reflect.InvocationTargetException;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IProjectDescription;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IPath;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.OperationCanceledException;
import org.eclipse.jface.dialogs.ErrorDialog;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.jface.wizard.Wizard;
import org.eclipse.ui.INewWizard;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.actions.WorkspaceModifyOperation;
import org.eclipse.ui.ide.IDE;

/** Creates a project that can run immediately, or none. */
public final class ProjectWizard extends Wizard implements INewWizard {

  private final ProjectPage page = new ProjectPage();
  private IWorkbench workbench;

  /** Called by the platform. */
  public ProjectWizard() {
    setWindowTitle("New Eventchain Project");
    setNeedsProgressMonitor(true);
  }

  @Override
  public void init(IWorkbench opened, IStructuredSelection selection) {
    workbench = opened;
  }

  @Override
  public void addPages() {
    addPage(page);
  }

  @Override
  public boolean performFinish() {
    IProject project = page.getProjectHandle();
    try {
      getContainer().run(true, true, operation(project));
      open(project);
      return true;
    } catch (InterruptedException e) {
      return false; // cancelled: everything was undone
    } catch (InvocationTargetException e) {
      if (!(e.getCause() instanceof CoreException failure)) {
        throw new IllegalStateException(e.getCause());
      }
      page.setErrorMessage(failure.getStatus().getMessage());
      return false;
    } catch (CoreException e) {
      page.setErrorMessage(e.getStatus().getMessage());
      return false;
    }
  }

  private WorkspaceModifyOperation operation(IProject project) throws CoreException {
    Program program = Program.find();
    ProjectContent content = new ProjectContent(program, page.folder());
    IPath location = page.useDefaults() ? null : page.getLocationPath();
    String example = page.example();
    String chain = page.chain();
    return new WorkspaceModifyOperation() {
      @Override
      protected void execute(IProgressMonitor monitor) throws CoreException, InterruptedException {
        monitor.beginTask("Creating " + project.getName(), IProgressMonitor.UNKNOWN);
        content.requireFree();
        boolean done = false;
        try {
          if (example.isEmpty()) {
            content.start(chain, monitor);
          } else {
            content.copy(ProjectContent.example(program, example), monitor);
          }
          create(project, location, monitor);
          done = true;
        } catch (OperationCanceledException e) {
          throw new InterruptedException();
        } finally {
          if (!done) {
            undo(project, content);
          }
        }
      }
    };
  }

  private static void create(IProject project, IPath location, IProgressMonitor monitor)
      throws CoreException {
    if (monitor.isCanceled()) {
      throw new OperationCanceledException();
    }
    IProjectDescription description =
        project.getWorkspace().newProjectDescription(project.getName());
    description.setLocation(location);
    project.create(description, null);
    project.open(null);
    project.setDefaultCharset("UTF-8", null);
    EventchainCore.setNature(project, true, monitor);
    project.refreshLocal(IResource.DEPTH_INFINITE, null);
  }

  private static void undo(IProject project, ProjectContent content) throws CoreException {
    boolean ours = project.exists() && content.isIn(project.getLocation());
    if (ours) {
      project.delete(false, true, null);
    }
    content.undo();
  }

  private void open(IProject project) {
    IFile chain = project.getFile(ProjectLayout.MODEL);
    IFile file = chain.exists() ? chain : project.getFile(ProjectLayout.CONFIGURATION);
    try {
      if (file.exists()) {
        IDE.openEditor(workbench.getActiveWorkbenchWindow().getActivePage(), file);
      }
    } catch (CoreException e) { // the project exists nevertheless
      ErrorDialog.openError(getShell(), getWindowTitle(), null, e.getStatus());
    }
  }
}

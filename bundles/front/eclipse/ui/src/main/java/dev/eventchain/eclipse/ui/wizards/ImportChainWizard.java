package dev.eventchain.eclipse.ui.wizards;

import dev.eventchain.eclipse.ChainImport;
import java.io.ByteArrayInputStream;
import java.lang.reflect.InvocationTargetException;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.Adapters;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.jface.wizard.Wizard;
import org.eclipse.ui.IImportWizard;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.actions.WorkspaceModifyOperation;
import org.eclipse.ui.ide.IDE;

/** Imports a chain's JSON description as a model. */
public final class ImportChainWizard extends Wizard implements IImportWizard {

  private IWorkbench workbench;
  private ImportPage page;

  /** Called by the platform. */
  public ImportChainWizard() {
    setWindowTitle("Event Chain from JSON");
    setNeedsProgressMonitor(true);
  }

  @Override
  public void init(IWorkbench opened, IStructuredSelection selection) {
    workbench = opened;
    IResource selected = Adapters.adapt(selection.getFirstElement(), IResource.class);
    IContainer folder =
        selected instanceof IContainer container || selected == null
            ? (IContainer) selected
            : selected.getParent();
    page = new ImportPage(folder);
  }

  @Override
  public void addPages() {
    addPage(page);
  }

  @Override
  public boolean performFinish() {
    ChainImport read = page.read().orElse(null);
    if (read == null) {
      return false; // the page shows the reason
    }
    IFile file = page.target();
    try {
      getContainer().run(false, false, write(file, read.model()));
      IDE.openEditor(workbench.getActiveWorkbenchWindow().getActivePage(), file);
      return true;
    } catch (InterruptedException e) {
      return false;
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

  private static WorkspaceModifyOperation write(IFile file, byte[] model) {
    return new WorkspaceModifyOperation() {
      @Override
      protected void execute(IProgressMonitor monitor) throws CoreException {
        ByteArrayInputStream bytes = new ByteArrayInputStream(model);
        if (file.exists()) {
          file.setContents(bytes, true, true, monitor);
        } else {
          file.create(bytes, true, monitor);
        }
      }
    };
  }
}

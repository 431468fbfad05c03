package dev.eventchain.eclipse;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IResourceDelta;
import org.eclipse.core.resources.IncrementalProjectBuilder;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.SubMonitor;
import org.eclipse.core.runtime.jobs.ISchedulingRule;

/** Checks the files saved since the last build, in the build's own job, and sets markers. */
public final class EventchainBuilder extends IncrementalProjectBuilder {

  /** Other projects are not read, so none has to be built with this one. */
  private static final IProject[] NO_OTHERS = new IProject[0];

  @Override
  protected IProject[] build(int kind, Map<String, String> arguments, IProgressMonitor monitor)
      throws CoreException {
    ProjectChecks checks = ProjectChecks.of(getProject());
    SubMonitor progress = SubMonitor.convert(monitor);
    IResourceDelta delta = kind == FULL_BUILD ? null : getDelta(getProject());
    if (delta == null || !checks.isComplete()) {
      checks.checkAll(progress);
    } else {
      checks.checkChanged(changed(delta), progress);
    }
    return NO_OTHERS;
  }

  /** Returns a rule for the project only, so that other jobs need not wait for a long check. */
  @Override
  public ISchedulingRule getRule(int kind, Map<String, String> arguments) {
    return getProject();
  }

  /** Returns the files that were changed, added or removed. */
  private static List<IFile> changed(IResourceDelta delta) throws CoreException {
    List<IFile> files = new ArrayList<>();
    delta.accept(
        each -> {
          boolean onlyMarkers =
              each.getKind() == IResourceDelta.CHANGED
                  && (each.getFlags() & ~(IResourceDelta.MARKERS | IResourceDelta.SYNC)) == 0;
          if (each.getResource().getType() == IResource.FILE && !onlyMarkers) {
            files.add((IFile) each.getResource());
          }
          return true;
        });
    return files;
  }

  @Override
  protected void clean(IProgressMonitor monitor) throws CoreException {
    ProjectChecks.of(getProject()).forget();
  }
}

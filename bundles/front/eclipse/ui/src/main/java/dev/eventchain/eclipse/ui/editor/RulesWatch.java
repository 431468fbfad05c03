package dev.eventchain.eclipse.ui.editor;

import java.util.function.Supplier;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IResourceChangeEvent;
import org.eclipse.core.resources.IResourceChangeListener;
import org.eclipse.core.resources.IResourceDelta;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.swt.widgets.Display;

/** Notifies an editor of changes in other files of its project, which may contain its rules. */
final class RulesWatch implements IResourceChangeListener {

  /** Flags of changes that do not affect the contents: markers and version control. */
  private static final int OF_NO_INTEREST = IResourceDelta.MARKERS | IResourceDelta.SYNC;

  private final Supplier<IFile> chain;
  private final Runnable changed;
  private final Display display = Display.getCurrent();

  /**
   * Watches until disposal.
   *
   * @param changed called on the user interface's thread
   */
  RulesWatch(Supplier<IFile> chain, Runnable changed) {
    this.chain = chain;
    this.changed = changed;
    ResourcesPlugin.getWorkspace()
        .addResourceChangeListener(this, IResourceChangeEvent.POST_CHANGE);
  }

  void dispose() {
    ResourcesPlugin.getWorkspace().removeResourceChangeListener(this);
  }

  @Override
  public void resourceChanged(IResourceChangeEvent event) {
    IFile file = chain.get();
    IResourceDelta delta =
        event.getDelta() == null
            ? null
            : event.getDelta().findMember(file.getProject().getFullPath());
    if (delta != null && changesAnother(delta, file) && !display.isDisposed()) {
      display.asyncExec(changed);
    }
  }

  private static boolean changesAnother(IResourceDelta delta, IFile file) {
    boolean[] found = new boolean[1];
    try {
      delta.accept(
          each -> {
            boolean content =
                each.getKind() != IResourceDelta.CHANGED
                    || (each.getFlags() & ~OF_NO_INTEREST) != 0;
            found[0] |=
                content
                    && each.getResource().getType() == IResource.FILE
                    && !each.getResource().equals(file);
            return !found[0];
          });
    } catch (CoreException e) {
      return true; // unknown, so check again
    }
    return found[0];
  }
}

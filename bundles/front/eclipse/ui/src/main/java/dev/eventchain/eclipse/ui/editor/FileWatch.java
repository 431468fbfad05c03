package dev.eventchain.eclipse.ui.editor;

import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResourceChangeEvent;
import org.eclipse.core.resources.IResourceChangeListener;
import org.eclipse.core.resources.IResourceDelta;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.swt.widgets.Display;

/** Notifies an editor of changes of its file. */
final class FileWatch implements IResourceChangeListener {

  /** A listener, called on the user interface's thread. */
  interface Listener {

    /** Called when the contents may have changed, or the file exists again. */
    void changed();

    /** Called after the file was moved. */
    void moved(IFile to);

    /** Called after the file was deleted. */
    void deleted();
  }

  private final IFile file;
  private final Listener listener;
  private final Display display = Display.getCurrent();

  FileWatch(IFile file, Listener listener) {
    this.file = file;
    this.listener = listener;
    ResourcesPlugin.getWorkspace()
        .addResourceChangeListener(this, IResourceChangeEvent.POST_CHANGE);
  }

  void dispose() {
    ResourcesPlugin.getWorkspace().removeResourceChangeListener(this);
  }

  @Override
  public void resourceChanged(IResourceChangeEvent event) {
    IResourceDelta delta =
        event.getDelta() == null ? null : event.getDelta().findMember(file.getFullPath());
    if (delta == null) {
      return;
    }
    boolean isMoved = (delta.getFlags() & IResourceDelta.MOVED_TO) != 0;
    boolean isContent =
        (delta.getFlags() & (IResourceDelta.CONTENT | IResourceDelta.REPLACED)) != 0;
    if (delta.getKind() == IResourceDelta.REMOVED && isMoved) {
      IFile to = ResourcesPlugin.getWorkspace().getRoot().getFile(delta.getMovedToPath());
      tell(() -> listener.moved(to));
    } else if (delta.getKind() == IResourceDelta.REMOVED) {
      tell(listener::deleted);
    } else if (delta.getKind() == IResourceDelta.ADDED || isContent) {
      tell(listener::changed);
    }
  }

  private void tell(Runnable what) {
    if (!display.isDisposed()) {
      display.asyncExec(what);
    }
  }
}

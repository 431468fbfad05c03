package dev.eventchain.eclipse.ui.diagram;

import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResourceChangeEvent;
import org.eclipse.core.resources.IResourceChangeListener;
import org.eclipse.core.resources.IResourceDelta;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.CoreException;

/** Watches a file, its markers and the neighbouring models that it may refer to. */
final class FileWatch implements IResourceChangeListener {

  private static final Set<String> MODELS = Set.of("xmi", "eventchain", "ecore");

  private final Runnable changed;
  private final Runnable marked;
  private final Consumer<IFile> moved;
  private volatile IFile file;

  /**
   * Creates a watch without a file. Callbacks come on any thread.
   *
   * @param changed called when the models may have changed
   * @param marked called when only the markers of the file have changed
   * @param moved called with the new file after a move
   */
  FileWatch(Runnable changed, Runnable marked, Consumer<IFile> moved) {
    this.changed = changed;
    this.marked = marked;
    this.moved = moved;
  }

  void start() {
    ResourcesPlugin.getWorkspace()
        .addResourceChangeListener(this, IResourceChangeEvent.POST_CHANGE);
  }

  void stop() {
    ResourcesPlugin.getWorkspace().removeResourceChangeListener(this);
  }

  /** Watches this file from now on; none for null. */
  void watch(IFile watched) {
    file = watched;
  }

  @Override
  public void resourceChanged(IResourceChangeEvent event) {
    IFile watched = file;
    if (watched == null || event.getDelta() == null) {
      return;
    }
    IResourceDelta own = event.getDelta().findMember(watched.getFullPath());
    if (own != null && (own.getFlags() & IResourceDelta.MOVED_TO) != 0) {
      moved.accept(ResourcesPlugin.getWorkspace().getRoot().getFile(own.getMovedToPath()));
      return;
    }
    IResourceDelta project = event.getDelta().findMember(watched.getProject().getFullPath());
    if (project != null && isOther(project)) {
      changed.run();
    } else if (own != null && (own.getFlags() & IResourceDelta.MARKERS) != 0) {
      marked.run();
    }
  }

  private static boolean isOther(IResourceDelta project) {
    boolean[] found = {false};
    try {
      project.accept(
          delta -> {
            found[0] |= isChange(delta);
            return !found[0];
          });
    } catch (CoreException e) {
      return true; // rather check again than miss a change
    }
    return found[0];
  }

  private static boolean isChange(IResourceDelta delta) {
    int flags = delta.getFlags();
    if (!(delta.getResource() instanceof IFile changedFile)) {
      return (flags & IResourceDelta.OPEN) != 0;
    }
    String extension = changedFile.getFileExtension();
    return extension != null
        && MODELS.contains(extension.toLowerCase(Locale.ROOT))
        && (delta.getKind() != IResourceDelta.CHANGED
            || (flags & (IResourceDelta.CONTENT | IResourceDelta.REPLACED)) != 0);
  }
}

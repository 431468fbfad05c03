package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.xmi.LoadedModel;
import dev.eventchain.xmi.Origins;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.function.Consumer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.IPath;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Status;
import org.eclipse.core.runtime.jobs.Job;

/** Reads chains from files, in a job. */
final class ChainLoader extends Job {

  /**
   * The result of loading.
   *
   * @param chain null if there is none
   * @param problem the reason why there is no chain; empty if there is one
   */
  record Result(IFile file, EventChain chain, Origins origins, String problem) {}

  private final Consumer<Result> receiver;
  private volatile IFile file;

  /**
   * Creates the loader of a view.
   *
   * @param receiver called on the job's thread, for the last requested file
   */
  ChainLoader(Consumer<Result> receiver) {
    super("Reading the event chain");
    this.receiver = receiver;
    setSystem(true);
    setPriority(SHORT);
  }

  /** Reads a file, and drops the one that is waiting. */
  void load(IFile next) {
    file = next;
    schedule();
  }

  @Override
  protected IStatus run(IProgressMonitor monitor) {
    IFile asked = file;
    Result result = read(asked);
    if (asked.equals(file)) {
      receiver.accept(result);
    }
    return Status.OK_STATUS;
  }

  private static Result read(IFile file) {
    IPath place = file.getLocation();
    if (!file.isAccessible()) {
      return failed(file, file.getFullPath() + " no longer exists, or its project is closed.");
    } else if (place == null) {
      return failed(file, file.getFullPath() + " is not in a folder on this machine.");
    }
    try {
      LoadedModel model = EventChainMetamodel.store(folders(file)).load(place.toFile().toPath());
      return model.roots().stream()
          .filter(EventChain.class::isInstance)
          .findFirst()
          .map(root -> new Result(file, (EventChain) root, model.origins(), ""))
          .orElseGet(() -> failed(file, file.getName() + " contains no event chain."));
    } catch (DiagnosticException e) {
      return failed(file, text(e, file));
    } catch (RuntimeException | StackOverflowError e) { // shown to people; a view must not fail
      return failed(file, file.getName() + " cannot be read: " + e);
    }
  }

  /** Returns the folders that references may lead into. */
  private static Set<Path> folders(IFile file) {
    Set<Path> folders = new LinkedHashSet<>();
    if (file.getProject().getLocation() != null) {
      folders.add(file.getProject().getLocation().toFile().toPath());
    }
    folders.add(file.getLocation().toFile().toPath().getParent()); // a linked file is elsewhere
    return folders;
  }

  private static String text(DiagnosticException e, IFile file) {
    Diagnostic first = e.diagnostics().get(0);
    int more = e.diagnostics().size() - 1;
    return place(first, file)
        + first.message()
        + (first.hint().isEmpty() ? "" : " " + first.hint())
        + (more == 0 ? "" : " (and " + more + " more)");
  }

  /** Returns the location as text, relative to the folders that references may lead into. */
  private static String place(Diagnostic diagnostic, IFile file) {
    String place = diagnostic.location().toString();
    for (Path folder : folders(file)) {
      String start = folder.toString().replace('\\', '/') + "/";
      if (place.startsWith(start)) {
        place = place.substring(start.length());
      }
    }
    return place.isEmpty() ? "" : place + ": ";
  }

  private static Result failed(IFile file, String problem) {
    return new Result(file, null, null, problem);
  }
}

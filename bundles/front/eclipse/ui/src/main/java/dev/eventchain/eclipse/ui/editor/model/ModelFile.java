package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.xmi.LoadedModel;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.InvocationTargetException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IPath;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Status;
import org.eclipse.ui.actions.WorkspaceModifyOperation;

/** The file of an editor: reads and writes it, and detects changes by others. */
public final class ModelFile {

  /**
   * A problem of a file.
   *
   * @param hint the hint, or empty
   * @param line from 1; 0 if it concerns no line
   */
  public record Problem(String message, String hint, int line) {

    private static Problem of(Diagnostic finding) {
      return new Problem(finding.message(), finding.hint(), finding.location().line());
    }
  }

  /** The model of a file, or its problems. */
  public record Content(Optional<EditedModel> model, List<Problem> problems) {

    private static Content wrong(String message, String hint) {
      return new Content(Optional.empty(), List.of(new Problem(message, hint, 0)));
    }
  }

  private IFile file;

  /** Content that the editor has last read or written. */
  private byte[] known = {};

  public ModelFile(IFile file) {
    this.file = file;
  }

  public IFile file() {
    return file;
  }

  /** Sets another file, with the same contents or not yet existing. */
  public void moveTo(IFile other) {
    file = other;
  }

  /** Reads the model as the command line does. */
  public Content load() {
    IPath location = file.getLocation();
    IPath project = file.getProject().getLocation();
    if (location == null || project == null) {
      return Content.wrong("The file is not on this machine's disk.", "Copy it into the project.");
    }
    known = bytes().orElse(new byte[0]);
    try {
      LoadedModel model = EventChainMetamodel.store(project.toPath()).load(location.toPath());
      return model.roots().stream()
          .filter(EventChain.class::isInstance)
          .findFirst()
          .map(chain -> new EditedModel(model, (EventChain) chain))
          .map(edited -> new Content(Optional.of(edited), List.of()))
          .orElseGet(() -> Content.wrong("The file contains no event chain.", ""));
    } catch (DiagnosticException e) {
      List<Problem> problems = e.diagnostics().stream().map(Problem::of).toList();
      return new Content(Optional.empty(), problems);
    } catch (RuntimeException | StackOverflowError e) {
      return Content.wrong("The file cannot be read: " + e, "");
    }
  }

  /** Returns whether the file has changed since it was last read or written here. */
  public boolean isChanged() {
    return bytes().filter(bytes -> !Arrays.equals(bytes, known)).isPresent();
  }

  private Optional<byte[]> bytes() {
    try (InputStream stream = file.getContents(true)) {
      return Optional.of(stream.readAllBytes());
    } catch (CoreException | IOException e) { // load() reports the reason
      return Optional.empty();
    }
  }

  /**
   * Asks the workspace for permission to write the file, which may make it writable.
   *
   * @param shell the parent shell of questions; null to ask none
   */
  public IStatus mayWrite(Object shell) {
    return file.exists() && file.isReadOnly()
        ? ResourcesPlugin.getWorkspace().validateEdit(new IFile[] {file}, shell)
        : Status.OK_STATUS;
  }

  /**
   * Writes the file; creates it if it does not exist.
   *
   * @throws CoreException if the workspace rejects the change
   */
  public void save(byte[] bytes, IProgressMonitor monitor) throws CoreException {
    byte[] before = known;
    known = bytes;
    try {
      new WorkspaceModifyOperation(file.exists() ? file : file.getParent()) {
        @Override
        protected void execute(IProgressMonitor progress) throws CoreException {
          write(bytes, progress);
        }
      }.run(monitor);
    } catch (InvocationTargetException e) {
      known = before;
      throw e.getCause() instanceof CoreException core ? core : failure(e.getCause());
    } catch (InterruptedException e) { // as for a cancelled operation
      known = before;
      throw failure(e);
    }
  }

  private void write(byte[] bytes, IProgressMonitor progress) throws CoreException {
    InputStream stream = new ByteArrayInputStream(bytes);
    if (file.exists()) {
      file.setContents(stream, IResource.KEEP_HISTORY, progress);
    } else {
      file.create(stream, IResource.NONE, progress);
    }
  }

  private static CoreException failure(Throwable cause) {
    return new CoreException(
        Status.error("The file was not written: " + cause.getMessage(), cause));
  }
}

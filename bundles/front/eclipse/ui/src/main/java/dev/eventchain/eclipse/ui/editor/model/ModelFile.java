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

/** The file of an editor: how it is read and written, and whether somebody else has changed it. */
public final class ModelFile {

  /**
   * What is wrong with a file.
   *
   * @param hint what to do about it, or empty
   * @param line from 1; 0 if it is about no line
   */
  public record Problem(String message, String hint, int line) {

    private static Problem of(Diagnostic finding) {
      return new Problem(finding.message(), finding.hint(), finding.location().line());
    }
  }

  /** The model of a file, or what is wrong with it. */
  public record Content(Optional<EditedModel> model, List<Problem> problems) {

    private static Content wrong(String message, String hint) {
      return new Content(Optional.empty(), List.of(new Problem(message, hint, 0)));
    }
  }

  private IFile file;

  /** What the editor has read or written last. */
  private byte[] known = {};

  public ModelFile(IFile file) {
    this.file = file;
  }

  public IFile file() {
    return file;
  }

  /** The file is another one from now on, of the same contents or none yet. */
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

  /** Whether the file is another one than was read or written here. */
  public boolean isChanged() {
    return bytes().filter(bytes -> !Arrays.equals(bytes, known)).isPresent();
  }

  private Optional<byte[]> bytes() {
    try (InputStream stream = file.getContents(true)) {
      return Optional.of(stream.readAllBytes());
    } catch (CoreException | IOException e) { // load() says why
      return Optional.empty();
    }
  }

  /**
   * Asks whether the file may be written, which may make it writable.
   *
   * @param shell what questions are asked on; null for none
   */
  public IStatus mayWrite(Object shell) {
    return file.exists() && file.isReadOnly()
        ? ResourcesPlugin.getWorkspace().validateEdit(new IFile[] {file}, shell)
        : Status.OK_STATUS;
  }

  /**
   * Writes the file, which is made if there is none.
   *
   * @throws CoreException with what the workspace says against it
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
    } catch (InterruptedException e) { // as a cancelled operation reports itself
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

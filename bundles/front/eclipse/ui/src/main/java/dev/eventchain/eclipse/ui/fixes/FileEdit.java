package dev.eventchain.eclipse.ui.fixes;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Status;
import org.eclipse.core.runtime.jobs.Job;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.part.FileEditorInput;

/** Changes the text of a file in a job, unless an editor has unsaved changes of it. */
final class FileEdit {

  /** Creates the new text from the old one; empty if that is no longer possible. */
  @FunctionalInterface
  interface Change {
    Optional<String> apply(String text) throws CoreException;
  }

  /** Encoding declaration of an XML file. */
  private static final Pattern ENCODING =
      Pattern.compile("\\A\\uFEFF?<\\?xml[^>]*encoding=[\"']([^\"']+)");

  private FileEdit() {}

  /** Starts the change, on the user interface's thread. */
  static void start(String name, IFile file, Change change) {
    IWorkbenchWindow window = PlatformUI.getWorkbench().getActiveWorkbenchWindow();
    Shell shell = window == null ? null : window.getShell();
    if (window != null && isDirty(window, file)) {
      MessageDialog.openInformation(
          shell, name, "Save " + file.getName() + " first: its editor has unsaved changes.");
      return;
    }
    IStatus writable = file.getWorkspace().validateEdit(new IFile[] {file}, shell);
    if (!writable.isOK()) {
      MessageDialog.openError(shell, name, writable.getMessage());
      return;
    }
    Job job =
        new Job(name) {
          @Override
          protected IStatus run(IProgressMonitor monitor) {
            return change(file, change, monitor);
          }
        };
    job.setRule(file.getWorkspace().getRuleFactory().modifyRule(file));
    job.schedule();
  }

  private static boolean isDirty(IWorkbenchWindow window, IFile file) {
    FileEditorInput input = new FileEditorInput(file);
    return Arrays.stream(window.getWorkbench().getWorkbenchWindows())
        .flatMap(each -> Arrays.stream(each.getPages()))
        .flatMap(page -> Arrays.stream(page.findEditors(input, null, IWorkbenchPage.MATCH_INPUT)))
        .map(reference -> reference.getEditor(false))
        .anyMatch(editor -> editor != null && editor.isDirty());
  }

  /** Decodes UTF-8; rejects other text, whose bytes would be lost. */
  private static String text(byte[] bytes) throws IOException {
    String text =
        StandardCharsets.UTF_8
            .newDecoder()
            .onMalformedInput(CodingErrorAction.REPORT)
            .onUnmappableCharacter(CodingErrorAction.REPORT)
            .decode(ByteBuffer.wrap(bytes))
            .toString();
    Matcher declared = ENCODING.matcher(text);
    if (declared.find() && !declared.group(1).equalsIgnoreCase("UTF-8")) {
      throw new IOException("it declares the encoding " + declared.group(1) + ", not UTF-8");
    }
    return text;
  }

  private static IStatus change(IFile file, Change change, IProgressMonitor monitor) {
    try (InputStream content = file.getContents()) {
      String text = text(content.readAllBytes());
      Optional<String> changed = change.apply(text);
      if (changed.isEmpty()) {
        return Status.error( // the platform shows it in a dialog
            "The text has changed in the meantime, or it is not certain what to change: fix it by"
                + " hand.");
      }
      byte[] bytes = changed.get().getBytes(StandardCharsets.UTF_8);
      file.setContents(new ByteArrayInputStream(bytes), IResource.KEEP_HISTORY, monitor);
      return Status.OK_STATUS;
    } catch (CoreException e) {
      return e.getStatus();
    } catch (IOException e) {
      return Status.error(file.getName() + " cannot be read: " + e.getMessage());
    }
  }
}

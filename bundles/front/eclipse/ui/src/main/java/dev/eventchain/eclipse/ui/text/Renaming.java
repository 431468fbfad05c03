package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.FileEdit;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Rename;
import dev.eventchain.editing.RenameTarget;
import dev.eventchain.editing.TextLines;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.eclipse.core.filebuffers.FileBuffers;
import org.eclipse.core.filebuffers.ITextFileBuffer;
import org.eclipse.core.filebuffers.ITextFileBufferManager;
import org.eclipse.core.filebuffers.LocationKind;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IPath;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Status;
import org.eclipse.jface.dialogs.InputDialog;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.window.Window;
import org.eclipse.text.edits.MultiTextEdit;
import org.eclipse.text.edits.ReplaceEdit;

/**
 * Gives something another name in all files, after people have seen the changes. Files that were
 * saved are saved again; texts with unsaved changes stay unsaved.
 */
final class Renaming {

  private static final String TITLE = "Rename";

  private final CodeEditor editor;
  private final CodeText text;

  private Renaming(CodeEditor editor) {
    this.editor = editor;
    this.text = editor.text();
  }

  /** Asks for the new name of what the word at an offset names. */
  static void start(CodeEditor editor, int offset) {
    Renaming renaming = new Renaming(editor);
    renaming.text.ask(offset, Analysis::renameTarget, target -> renaming.name(offset, target));
  }

  private void name(int offset, RenameTarget target) {
    if (!target.isAllowed()) {
      refuse(target.refusal());
      return;
    }
    InputDialog dialog =
        new InputDialog(
            editor.getSite().getShell(),
            TITLE,
            "New name of '" + target.name() + "':",
            target.name(),
            name -> name.isBlank() || name.equals(target.name()) ? "" : null);
    if (dialog.open() == Window.OK) {
      String name = dialog.getValue().strip();
      text.ask(offset, (analysis, position) -> analysis.rename(position, name), this::preview);
    }
  }

  private void refuse(String reason) {
    MessageDialog.openInformation(editor.getSite().getShell(), TITLE, reason);
  }

  private void preview(Rename rename) {
    if (!rename.isAllowed()) {
      refuse(rename.refusal());
      return;
    }
    Map<Path, List<FileEdit>> edits =
        rename.edits().stream()
            .collect(
                Collectors.groupingBy(FileEdit::file, LinkedHashMap::new, Collectors.toList()));
    Map<Path, String> seen = new LinkedHashMap<>();
    edits.keySet().forEach(file -> seen.put(file, text.textOf(file).orElse("")));
    List<FileRange> places =
        rename.edits().stream().map(each -> new FileRange(each.file(), each.range())).toList();
    String message =
        "%d changes in %d files. OK makes all of them:".formatted(places.size(), edits.size());
    if (Declarations.list(editor, TITLE, message, places) == null) {
      return;
    }
    IStatus status = writable(edits.keySet().stream().toList());
    status = status.isOK() ? apply(edits, seen) : status;
    if (!status.isOK()) {
      MessageDialog.openError(editor.getSite().getShell(), TITLE, status.getMessage());
    }
  }

  private IStatus writable(List<Path> files) {
    IFile[] known =
        files.stream().flatMap(each -> Declarations.file(each).stream()).toArray(IFile[]::new);
    return ResourcesPlugin.getWorkspace().validateEdit(known, editor.getSite().getShell());
  }

  /** Changes all files, or none if one of them no longer has the text that people have seen. */
  private static IStatus apply(Map<Path, List<FileEdit>> edits, Map<Path, String> seen) {
    Map<Path, ITextFileBuffer> buffers = new LinkedHashMap<>();
    try {
      for (Path file : edits.keySet()) {
        buffers.put(file, connect(file));
        if (!buffers.get(file).getDocument().get().equals(seen.get(file))) {
          return Status.error(file.getFileName() + " has changed meanwhile: nothing was renamed.");
        }
      }
      List<ITextFileBuffer> saved = new ArrayList<>();
      for (Map.Entry<Path, ITextFileBuffer> each : buffers.entrySet()) {
        if (!each.getValue().isDirty()) {
          saved.add(each.getValue());
        }
        change(each.getValue(), edits.get(each.getKey()));
      }
      for (ITextFileBuffer each : saved) {
        each.commit(null, false);
      }
      return Status.OK_STATUS;
    } catch (CoreException e) {
      return e.getStatus();
    } catch (BadLocationException e) {
      return Status.error("The changes do not fit the text.", e);
    } finally {
      buffers.keySet().forEach(Renaming::disconnect);
    }
  }

  private static ITextFileBuffer connect(Path file) throws CoreException {
    ITextFileBufferManager manager = FileBuffers.getTextFileBufferManager();
    manager.connect(location(file), kind(file), null);
    return manager.getTextFileBuffer(location(file), kind(file));
  }

  private static void change(ITextFileBuffer buffer, List<FileEdit> edits)
      throws BadLocationException {
    TextLines lines = new TextLines(buffer.getDocument().get());
    MultiTextEdit all = new MultiTextEdit();
    for (FileEdit each : edits) {
      int start = lines.offset(each.range().start());
      int length = lines.offset(each.range().end()) - start;
      all.addChild(new ReplaceEdit(start, length, each.newText()));
    }
    all.apply(buffer.getDocument());
  }

  private static void disconnect(Path file) {
    try {
      FileBuffers.getTextFileBufferManager().disconnect(location(file), kind(file), null);
    } catch (CoreException e) {
      return; // the buffer is not needed any more
    }
  }

  /** Returns the location by which editors know a file, so that their text is changed. */
  private static IPath location(Path file) {
    return Declarations.file(file)
        .map(IFile::getFullPath)
        .orElseGet(() -> IPath.fromOSString(file.toString()));
  }

  private static LocationKind kind(Path file) {
    return Declarations.file(file).isPresent() ? LocationKind.IFILE : LocationKind.LOCATION;
  }
}

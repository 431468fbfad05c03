package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.FileEdit;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Rename;
import dev.eventchain.editing.RenameTarget;
import dev.eventchain.editing.TextPosition;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.jface.dialogs.InputDialog;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.jface.window.Window;

/**
 * Gives something another name in all files, after people have seen the changes. Files that were
 * saved are saved again; texts with unsaved changes stay unsaved.
 */
final class Renaming {

  private static final String TITLE = "Rename";

  /** The changes of a renaming, and the texts that they fit. */
  private record Planned(Rename rename, Map<Path, String> texts) {

    static Planned of(Rename rename, CodeText text) {
      return new Planned(
          rename, text.textsOf(rename.edits().stream().map(FileEdit::file).toList()));
    }
  }

  private final CodeEditor editor;
  private final CodeText text;
  private final int offset;

  /** The text in which the offset was taken. */
  private final CodeText.Present asked;

  private Renaming(CodeEditor editor, int offset) {
    this.editor = editor;
    this.text = editor.text();
    this.offset = offset;
    this.asked = text.present();
  }

  /** Asks for the new name of what the word at an offset names. */
  static void start(CodeEditor editor, int offset) {
    Renaming renaming = new Renaming(editor, offset);
    renaming.ask(Analysis::renameTarget, renaming::name);
  }

  /** Asks about the text as it was at the beginning; ends if it has changed. */
  private <T> void ask(BiFunction<Analysis, TextPosition, T> question, Consumer<T> then) {
    if (isUnchanged()) {
      text.ask(
          offset,
          question,
          answer -> {
            if (isUnchanged()) {
              then.accept(answer);
            }
          },
          () -> refuse("The text could not be analysed: nothing was renamed. The log says why."));
    }
  }

  private boolean isUnchanged() {
    if (text.present() == asked) {
      return true;
    }
    refuse(text.path().getFileName() + " has changed meanwhile: nothing was renamed.");
    return false;
  }

  private void name(RenameTarget target) {
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
      ask((analysis, position) -> Planned.of(analysis.rename(position, name), text), this::preview);
    }
  }

  private void refuse(String reason) {
    MessageDialog.openInformation(editor.getSite().getShell(), TITLE, reason);
  }

  private void preview(Planned planned) {
    Rename rename = planned.rename();
    if (!rename.isAllowed()) {
      refuse(rename.refusal());
      return;
    }
    Map<Path, List<FileEdit>> edits =
        rename.edits().stream()
            .collect(
                Collectors.groupingBy(FileEdit::file, LinkedHashMap::new, Collectors.toList()));
    List<FileRange> places =
        rename.edits().stream().map(each -> new FileRange(each.file(), each.range())).toList();
    String message =
        String.format(
            Locale.ROOT,
            "%d changes in %d files. OK makes all of them:",
            places.size(),
            edits.size());
    if (Declarations.list(editor, TITLE, message, Declarations.listed(planned.texts(), places))
        == null) {
      return;
    }
    IStatus status = writable(edits.keySet().stream().toList());
    status = status.isOK() ? new RenamedFiles(planned.texts()).change(edits) : status;
    if (!status.isOK()) {
      MessageDialog.openError(editor.getSite().getShell(), TITLE, status.getMessage());
    }
  }

  private IStatus writable(List<Path> files) {
    IFile[] known =
        files.stream().flatMap(each -> Declarations.file(each).stream()).toArray(IFile[]::new);
    return ResourcesPlugin.getWorkspace().validateEdit(known, editor.getSite().getShell());
  }
}

package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.model.eventchain.EventChain;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.Adapters;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.ide.ResourceUtil;
import org.eclipse.ui.part.FileEditorInput;

/**
 * The subject of the view.
 *
 * @param editor the editor that has the chain in memory; null if it is read from the file
 * @param file the file of the chain; null if the editor has none
 */
record Subject(IEditorPart editor, IFile file) {

  private static final Set<String> EXTENSIONS = Set.of("xmi", "eventchain");

  /** Returns whether a file can be the model of a chain, by its name. */
  static boolean isModel(IFile file) {
    String extension = file.getFileExtension();
    return extension != null && EXTENSIONS.contains(extension.toLowerCase(Locale.ROOT));
  }

  /** Returns the chain of an editor: its own one, or else that of its file. */
  static Optional<Subject> of(IEditorPart editor) {
    IFile file = ResourceUtil.getFile(editor.getEditorInput());
    if (chain(editor) != null) {
      return Optional.of(new Subject(editor, file));
    }
    return file == null || !isModel(file) ? Optional.empty() : Optional.of(new Subject(null, file));
  }

  /** Returns the chain of a file, or of the editor that is open on it. */
  static Subject of(IFile file, IWorkbenchPage page) {
    IEditorPart editor = page.findEditor(new FileEditorInput(file));
    return editor != null && chain(editor) != null
        ? new Subject(editor, file)
        : new Subject(null, file);
  }

  /** Returns the chain in memory; null if there is none. */
  EventChain chain() {
    return editor == null ? null : chain(editor);
  }

  private static EventChain chain(IEditorPart editor) {
    return Adapters.adapt(editor, EventChain.class);
  }

  /** Returns the name for people. */
  String name() {
    return file != null ? file.getName() : editor.getTitle();
  }
}

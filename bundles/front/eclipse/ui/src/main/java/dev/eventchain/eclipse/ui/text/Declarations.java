package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.TextLines;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.core.filesystem.EFS;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.ILog;
import org.eclipse.jface.viewers.ArrayContentProvider;
import org.eclipse.jface.viewers.LabelProvider;
import org.eclipse.jface.window.Window;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.PartInitException;
import org.eclipse.ui.dialogs.ListDialog;
import org.eclipse.ui.editors.text.EditorsUI;
import org.eclipse.ui.ide.IDE;
import org.eclipse.ui.part.FileEditorInput;
import org.eclipse.ui.texteditor.ITextEditor;

/** Goes from a name to where it is declared, and to where else it is used. */
final class Declarations {

  /** A place in a list. */
  record Listed(FileRange place, String text) {

    /** Describes a place by the name of its file, the number of its line and the line itself. */
    static Listed of(FileRange place, List<String> lines) {
      int line = place.range().start().line();
      String text = line < lines.size() ? lines.get(line).strip() : "";
      return new Listed(place, place.file().getFileName() + ":" + (line + 1) + ": " + text);
    }

    @Override
    public String toString() {
      return text;
    }
  }

  private Declarations() {}

  /** Opens where that is declared what the word at an offset names; several are listed. */
  static void open(CodeEditor editor, int offset) {
    CodeText text = editor.text();
    text.ask(
        offset,
        (analysis, position) -> listed(text, analysis.definitions(position)),
        places -> {
          if (places.size() == 1) {
            show(editor, places.get(0).place());
          } else {
            choose(editor, "Declarations", places);
          }
        });
  }

  /** Lists where that is used what the word at an offset names. */
  static void references(CodeEditor editor, int offset) {
    CodeText text = editor.text();
    text.ask(
        offset,
        (analysis, position) -> listed(text, analysis.references(position, true)),
        places -> choose(editor, "References", places));
  }

  /** Describes places; only in answers, since it reads files. */
  static List<Listed> listed(CodeText text, List<FileRange> places) {
    return listed(text.textsOf(places.stream().map(FileRange::file).toList()), places);
  }

  /** Describes places in texts. */
  static List<Listed> listed(Map<Path, String> texts, List<FileRange> places) {
    Map<Path, List<String>> lines = new HashMap<>();
    texts.forEach((file, text) -> lines.put(file, List.of(text.split("\r\n|\r|\n", -1))));
    return places.stream().map(each -> Listed.of(each, lines.get(each.file()))).toList();
  }

  private static void choose(CodeEditor editor, String title, List<Listed> places) {
    if (places.isEmpty()) {
      editor.say("No file of the project declares or uses this.");
      return;
    }
    Object[] chosen = list(editor, title, places.size() + " places:", places);
    if (chosen != null && chosen.length > 0 && chosen[0] instanceof Listed listed) {
      show(editor, listed.place());
    }
  }

  /** Returns what people choose of a list of places; null if they cancel. */
  static Object[] list(CodeEditor editor, String title, String message, List<Listed> places) {
    ListDialog dialog = new ListDialog(editor.getSite().getShell());
    dialog.setTitle(title);
    dialog.setMessage(message);
    dialog.setContentProvider(ArrayContentProvider.getInstance());
    dialog.setLabelProvider(new LabelProvider());
    dialog.setInput(places);
    dialog.setInitialSelections(places.get(0));
    dialog.setWidthInChars(90);
    return dialog.open() == Window.OK ? dialog.getResult() : null;
  }

  /** Returns a file of Eclipse's workspace; empty for one outside. */
  static Optional<IFile> file(Path path) {
    return Arrays.stream(
            ResourcesPlugin.getWorkspace().getRoot().findFilesForLocationURI(path.toUri()))
        .filter(IFile::exists)
        .findFirst();
  }

  private static void show(CodeEditor editor, FileRange place) {
    try {
      IEditorPart opened = opened(editor.getSite().getPage(), place.file());
      if (opened instanceof ITextEditor text) {
        String content = text.getDocumentProvider().getDocument(text.getEditorInput()).get();
        TextLines lines = new TextLines(content);
        int start = lines.offset(place.range().start());
        text.selectAndReveal(start, lines.offset(place.range().end()) - start);
      }
    } catch (PartInitException e) {
      ILog.of(Declarations.class).error(place.file() + " cannot be opened.", e);
      editor.say(place.file() + " cannot be opened: " + e.getMessage());
    }
  }

  /** Opens metamodels as texts, since places in them are places in texts. */
  private static IEditorPart opened(IWorkbenchPage page, Path path) throws PartInitException {
    Optional<IFile> file = file(path);
    if (file.isEmpty()) {
      return IDE.openEditorOnFileStore(page, EFS.getLocalFileSystem().getStore(path.toUri()));
    }
    return path.toString().endsWith(".ecore")
        ? IDE.openEditor(page, new FileEditorInput(file.get()), EditorsUI.DEFAULT_TEXT_EDITOR_ID)
        : IDE.openEditor(page, file.get());
  }
}

package dev.eventchain.eclipse.ui.editor;

import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.text.IDocument;
import org.eclipse.ui.texteditor.ITextEditor;

/** A line of a text editor. */
final class TextLine {

  private TextLine() {}

  /** Selects a line, counted from 1, if the text has it. */
  static void show(ITextEditor editor, int line) {
    IDocument document = editor.getDocumentProvider().getDocument(editor.getEditorInput());
    try {
      int length = document.getLineLength(line - 1);
      editor.selectAndReveal(document.getLineOffset(line - 1), length);
    } catch (BadLocationException e) { // the text is shorter now
      editor.selectAndReveal(document.getLength(), 0);
    }
  }
}

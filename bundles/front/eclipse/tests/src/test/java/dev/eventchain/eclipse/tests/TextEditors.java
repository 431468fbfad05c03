package dev.eventchain.eclipse.tests;

import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.ITextViewer;
import org.eclipse.jface.text.source.ISourceViewer;
import org.eclipse.jface.text.source.SourceViewerConfiguration;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.widgets.Control;
import org.eclipse.ui.editors.text.TextEditor;
import org.eclipse.ui.texteditor.AbstractTextEditor;

/** Editors of texts in a workbench, and the texts that tests open in them. */
final class TextEditors {

  /** Rules of which one uses an operation that is defined above it. */
  static final String RULES =
      """
      context SoftwareNode
        def: isFast() : Boolean = self.frequency > 20
        inv Fast: isFast() or self.name <> 'slow'
        inv Later: not isFast() implies self.nextstep->notEmpty()
      """;

  /** A template that calls {@code line} of the module {@code base}. */
  static final String MAIN =
      """
      [module main('http://eventchain.dev/eventchain/1.0')]
      [import base/]
      [template public all(chain : EventChain)]
      [for (node | chain.software)]
      [line(node)/]
      [/for]
      [/template]
      """;

  private TextEditors() {}

  /** Returns the document that an editor shows. */
  static IDocument document(TextEditor editor) {
    return editor.getDocumentProvider().getDocument(editor.getEditorInput());
  }

  /** Returns the viewer of an editor. */
  static ISourceViewer viewer(TextEditor editor) {
    return (ISourceViewer) editor.getAdapter(ITextViewer.class);
  }

  /** Returns the configuration that the platform asks, too. */
  static SourceViewerConfiguration configuration(TextEditor editor) throws Exception {
    var method = AbstractTextEditor.class.getDeclaredMethod("getSourceViewerConfiguration");
    method.setAccessible(true);
    return (SourceViewerConfiguration) method.invoke(editor);
  }

  /** Returns the widget with the text of an editor. */
  static StyledText widget(TextEditor editor) {
    return (StyledText) editor.getAdapter(Control.class);
  }
}

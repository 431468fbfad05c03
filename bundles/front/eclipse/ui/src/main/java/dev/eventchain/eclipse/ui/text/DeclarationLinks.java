package dev.eventchain.eclipse.ui.text;

import org.eclipse.jface.text.IRegion;
import org.eclipse.jface.text.ITextViewer;
import org.eclipse.jface.text.hyperlink.AbstractHyperlinkDetector;
import org.eclipse.jface.text.hyperlink.IHyperlink;

/** Makes names links to their declarations. Keywords, texts and numbers are none. */
final class DeclarationLinks extends AbstractHyperlinkDetector {

  private final CodeEditor editor;

  DeclarationLinks(CodeEditor editor) {
    this.editor = editor;
  }

  @Override
  public IHyperlink[] detectHyperlinks(ITextViewer viewer, IRegion region, boolean several) {
    IRegion word = CodeEditor.word(viewer.getDocument(), region.getOffset());
    return word.getLength() == 0 || !editor.isName(word.getOffset())
        ? null // none, as the platform requires
        : new IHyperlink[] {new Link(editor, word)};
  }

  private record Link(CodeEditor editor, IRegion word) implements IHyperlink {
    @Override
    public IRegion getHyperlinkRegion() {
      return word;
    }

    @Override
    public String getTypeLabel() {
      return null; // the platform's value for none
    }

    @Override
    public String getHyperlinkText() {
      return "Open Declaration";
    }

    @Override
    public void open() {
      Declarations.open(editor, word.getOffset());
    }
  }
}

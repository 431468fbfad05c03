package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.Completion;
import java.util.Locale;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.text.DocumentEvent;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.ITextViewer;
import org.eclipse.jface.text.TextUtilities;
import org.eclipse.jface.text.contentassist.ICompletionProposal;
import org.eclipse.jface.text.contentassist.ICompletionProposalExtension2;
import org.eclipse.jface.text.contentassist.ICompletionProposalExtension6;
import org.eclipse.jface.text.contentassist.IContextInformation;
import org.eclipse.jface.viewers.StyledString;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.Point;

/**
 * A proposal of the analysis. People type on while it is listed: what they typed is replaced, too.
 *
 * @param start the offset of the typed prefix
 * @param behind the number of characters after the caret that are replaced: the rest of a word
 */
record CodeProposal(Completion completion, int start, int behind)
    implements ICompletionProposal, ICompletionProposalExtension2, ICompletionProposalExtension6 {

  /** Returns the proposal for a caret. */
  static CodeProposal of(Completion completion, CodeText.Present present, int caret) {
    int start = Math.min(caret, present.lines().offset(completion.replaced().start()));
    int end = Math.max(caret, present.lines().offset(completion.replaced().end()));
    return new CodeProposal(completion, start, end - caret);
  }

  /** Returns whether the proposal begins with a prefix, in upper or lower case. */
  boolean fits(String prefix) {
    String label = completion.label().toLowerCase(Locale.ROOT);
    return label.startsWith(prefix.toLowerCase(Locale.ROOT));
  }

  @Override
  public boolean validate(IDocument document, int offset, DocumentEvent event) {
    try {
      return offset >= start && fits(document.get(start, offset - start));
    } catch (BadLocationException e) {
      return false; // the text before it is gone
    }
  }

  @Override
  public void apply(ITextViewer viewer, char trigger, int stateMask, int offset) {
    IDocument document = viewer.getDocument();
    String source = fitted(completion.insertText(), document);
    Snippet snippet = completion.snippet() ? Snippet.of(source) : Snippet.plain(source);
    try {
      int end = Math.min(document.getLength(), offset + behind);
      document.replace(start, end - start, snippet.text());
    } catch (BadLocationException e) {
      return; // the text has changed under the list
    }
    snippet.fillIn(viewer, start);
  }

  /** Returns a text with the line breaks of a document, and its lines indented as the first. */
  private String fitted(String text, IDocument document) {
    String next = TextUtilities.getDefaultLineDelimiter(document) + indentation(document);
    return String.join(next, text.split("\r\n?|\n", -1));
  }

  /** Returns the space before the first word of the line. */
  private String indentation(IDocument document) {
    try {
      int line = document.getLineInformationOfOffset(start).getOffset();
      String before = document.get(line, start - line);
      return before.substring(0, before.length() - before.stripLeading().length());
    } catch (BadLocationException e) {
      return ""; // replacing fails, too
    }
  }

  /** Never called: proposals of {@link ICompletionProposalExtension2} are applied to a viewer. */
  @Override
  public void apply(IDocument document) {
    throw new UnsupportedOperationException("only a viewer has the caret");
  }

  @Override
  public Point getSelection(IDocument document) {
    return null; // it has been set already
  }

  @Override
  public String getDisplayString() {
    return getStyledDisplayString().getString();
  }

  @Override
  public StyledString getStyledDisplayString() {
    StyledString text = new StyledString(completion.label());
    if (!completion.detail().isEmpty()) {
      text.append("  " + completion.detail(), StyledString.QUALIFIER_STYLER);
    }
    return text;
  }

  @Override
  public String getAdditionalProposalInfo() {
    return completion.documentation().isEmpty()
        ? null // no window opens
        : CodeHover.plain(completion.documentation());
  }

  @Override
  public Image getImage() {
    return null; // none is shown
  }

  @Override
  public IContextInformation getContextInformation() {
    return null; // there is none
  }

  @Override
  public void selected(ITextViewer viewer, boolean smartToggle) {
    // Nothing is shown in the text before it is applied.
  }

  @Override
  public void unselected(ITextViewer viewer) {
    // Nothing was shown.
  }
}
